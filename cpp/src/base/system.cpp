// SPDX-License-Identifier: LGPL-2.1-or-later
#include "base/system.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <system_error>

#include "base/safe_file.h"
#include "base/timer.h"

#ifndef _WIN32
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/syscall.h>
#endif
#ifdef __APPLE__
#include <mach-o/dyld.h>
#include <mach/mach.h>
#include <pthread/qos.h>
#endif

#ifndef _WIN32
double swept::threadSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
#endif

namespace swept::os {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file) {
  throw std::system_error(errno, std::system_category(), "'" + utf8FromPath(file) + "'");
}

fs::path unusedName(const fs::path& folder, const std::string& suffix) {
  static std::atomic<unsigned> counter{0};
  std::random_device random;
  return folder / pathFromUtf8("swept-" + std::to_string(random()) + "-" +
                               std::to_string(counter.fetch_add(1)) + suffix);
}

}  // namespace

std::string ScratchFile::finish() {
  if (std::fflush(file_) != 0) fail(name_);
#ifdef __linux__
  return "/proc/self/fd/" + std::to_string(fileno(file_));
#else
  return utf8FromPath(name_);
#endif
}

ScratchFile::ScratchFile() : name_(newTemporaryFile("")), file_(openFile(name_, "wb")) {
  if (file_ == nullptr) fail(name_);
#ifdef __linux__
  std::error_code ignored;
  fs::remove(name_, ignored);
#endif
}

ScratchFile::~ScratchFile() {
  if (file_ != nullptr) std::fclose(file_);
  std::error_code ignored;
  fs::remove(name_, ignored);
}

void ScratchFile::write(const char* bytes, std::size_t count) {
  errno = 0;
  if (std::fwrite(bytes, 1, count, file_) != count) fail(name_);
}

fs::path newTemporaryFile(const std::string& suffix) {
  const fs::path folder = fs::temp_directory_path();
  constexpr int kAttempts = 100;
  for (int i = 0; i < kAttempts; ++i) {
    const fs::path name = unusedName(folder, suffix);
    createPrivate(name);
    if (errno == 0) return name;
    if (errno != EEXIST) fail(name);
  }
  fail(folder);
}

#ifndef _WIN32  // Windows: system_windows.cpp

namespace {

constexpr std::array<int, 3> kInterrupts{SIGINT, SIGTERM, SIGHUP};

#ifdef __linux__
/// Returns the value, in bytes, of a line "name:   1234 kB"; 0 if the file has no such line.
std::uint64_t lineOf(const char* path, const std::string& name) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.compare(0, name.size(), name) == 0) {
      return 1024 * std::strtoull(line.c_str() + name.size(), nullptr, 10);
    }
  }
  return 0;
}
#endif

}  // namespace

#ifdef __linux__
std::uint64_t residentMemory() {
  const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  std::array<char, 128> text{};
  const ssize_t length = read(file, text.data(), text.size() - 1);
  close(file);
  const char* resident = length > 0 ? std::strchr(text.data(), ' ') : nullptr;
  if (resident == nullptr) return 0;
  return std::strtoull(resident, nullptr, 10) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}
std::uint64_t peakMemory() { return lineOf("/proc/self/status", "VmHWM:"); }
std::uint64_t availableMemory() { return lineOf("/proc/meminfo", "MemAvailable:"); }
#elif defined(__APPLE__)
std::uint64_t residentMemory() {
  mach_task_basic_info info{};
  mach_msg_type_number_t count = MACH_TASK_BASIC_INFO_COUNT;
  const kern_return_t status = task_info(mach_task_self(), MACH_TASK_BASIC_INFO,
                                         reinterpret_cast<task_info_t>(&info), &count);
  return status == KERN_SUCCESS ? info.resident_size : 0;
}
std::uint64_t peakMemory() {
  struct rusage usage {};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<std::uint64_t>(usage.ru_maxrss) : 0;
}
std::uint64_t availableMemory() {
  vm_statistics64 pages{};
  mach_msg_type_number_t count = HOST_VM_INFO64_COUNT;
  const kern_return_t status = host_statistics64(mach_host_self(), HOST_VM_INFO64,
                                                 reinterpret_cast<host_info64_t>(&pages), &count);
  if (status != KERN_SUCCESS) return 0;
  const std::uint64_t unused =
      std::uint64_t{pages.free_count} + pages.inactive_count + pages.purgeable_count;
  return unused * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}
#else
std::uint64_t residentMemory() { return 0; }
std::uint64_t peakMemory() { return 0; }
std::uint64_t availableMemory() { return 0; }
#endif

void returnFreeMemory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

#ifdef __GLIBC__
bool setHeap(HeapSetting setting) {
  // kUsualTrim is the largest value to which the GNU C library itself raises M_TRIM_THRESHOLD.
  // kUsualMaps is its default for M_MMAP_MAX, the largest number of blocks outside the heap.
  constexpr int kUsualTrim = 64 << 20, kUsualMaps = 65536, kNoTrim = 1 << 30;
  mallopt(M_TRIM_THRESHOLD, setting == HeapSetting::Usual ? kUsualTrim : kNoTrim);
  mallopt(M_MMAP_MAX, setting == HeapSetting::OneHeap ? 0 : kUsualMaps);
  return true;
}
#else
bool setHeap(HeapSetting /*setting*/) { return false; }
#endif

unsigned createPrivate(const fs::path& file) {
  const int handle = ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (handle < 0) return 0;
  struct stat usual {};
  const bool known = ::fstat(handle, &usual) == 0;
  if (known) ::fchmod(handle, 0600);
  ::close(handle);
  errno = 0;  // a file system without modes is no error
  return known ? usual.st_mode & 0777U : 0;
}

int flushToDisk(const fs::path& file) {
  const int handle = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return 0;
  const int failed = ::fsync(handle) != 0 ? errno : 0;
  ::close(handle);
  return failed == EINVAL ? 0 : failed;  // a file system that cannot flush
}

bool mayWrite(const fs::path& file) { return ::access(file.c_str(), W_OK) == 0; }
bool mayRead(const fs::path& file) { return ::access(file.c_str(), R_OK) == 0; }

std::FILE* openFile(const fs::path& file, const char* mode) {
  return std::fopen(file.c_str(), mode);
}

std::vector<std::string> commandLine(int argc, char** argv) { return {argv + 1, argv + argc}; }
std::string standardInputName() { return "/dev/stdin"; }
std::string standardOutputName() { return "/dev/stdout"; }
std::string nullDeviceName() { return "/dev/null"; }
bool isDeviceName(const std::string& name) { return name.starts_with("/dev/"); }
bool isTerminal(std::FILE* stream) { return ::isatty(fileno(stream)) != 0; }

void onInterrupt(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  for (const int number : kInterrupts) {
    struct sigaction old {};
    sigaction(number, &action, &old);
    if (number == SIGHUP && old.sa_handler == SIG_IGN) std::signal(number, SIG_IGN);
  }
}
void ignoreInterrupts() {
  for (const int number : kInterrupts) std::signal(number, SIG_IGN);
}
void ignoreWriteSignals() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

fs::path programPath() {
  std::error_code failed;
#ifdef __APPLE__
  std::array<char, 4096> name{};
  std::uint32_t size = name.size();
  return _NSGetExecutablePath(name.data(), &size) == 0 ? fs::canonical(name.data(), failed)
                                                       : fs::path();
#else
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path() : program;
#endif
}

std::uint64_t processId() { return static_cast<std::uint64_t>(getpid()); }

void lowerThreadPriority() {
#ifdef __linux__
  // Nice value, 0 to 19. A thread at 0 gets nine times the time of a thread at 10.
  constexpr int kNice = 10;
  static_cast<void>(setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kNice));
#elif defined(__APPLE__)
  pthread_set_qos_class_self_np(QOS_CLASS_UTILITY, 0);
#endif
}

void* openLibrary(const std::string& name, std::string& why) {
  void* library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* error = dlerror();
    why = error != nullptr ? error : name;
  }
  return library;
}
void* symbolOf(void* library, const char* name) { return dlsym(library, name); }

#endif

}  // namespace swept::os
