// SPDX-License-Identifier: LGPL-2.1-or-later
#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <windows.h>
// These headers use types of windows.h, so they come after it.
#include <psapi.h>
#include <shellapi.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "base/safe_file.h"
#include "base/system.h"
#include "base/timer.h"

double swept::threadSeconds() {
  constexpr double kUnit = 1e-7;  // of a FILETIME, in seconds
  const auto seconds = [](const FILETIME& time) {
    return kUnit *
           static_cast<double>((std::uint64_t{time.dwHighDateTime} << 32U) | time.dwLowDateTime);
  };
  FILETIME begun{}, ended{}, kernel{}, user{};
  GetThreadTimes(GetCurrentThread(), &begun, &ended, &kernel, &user);
  return seconds(kernel) + seconds(user);
}

namespace swept::os {
namespace {

namespace fs = std::filesystem;

constexpr std::array<int, 3> kInterrupts{SIGINT, SIGTERM, SIGBREAK};

void (*interruptHandler)(int) = nullptr;

// Calls the handler of onInterrupt(). Windows resets a signal to its default action before it calls
// the handler, so onSignal() installs itself again.
void onSignal(int number) {
  std::signal(number, onSignal);
  if (interruptHandler != nullptr) interruptHandler(number);
}

std::string utf8FromWide(const wchar_t* text) { return utf8FromPath(fs::path(text)); }

PROCESS_MEMORY_COUNTERS memoryCounters() {
  PROCESS_MEMORY_COUNTERS counters{};
  GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
  return counters;
}

int errnoOfLastError() {
  switch (GetLastError()) {
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      return EEXIST;
    case ERROR_PATH_NOT_FOUND:
    case ERROR_FILE_NOT_FOUND:
      return ENOENT;
    case ERROR_DISK_FULL:
      return ENOSPC;
    default:
      return EACCES;
  }
}

/// Quotes a word so that CommandLineToArgvW() in the started program returns it unchanged.
std::wstring quoted(const std::string& word) {
  std::wstring text = L"\"";
  std::size_t slashes = 0;
  for (const wchar_t c : pathFromUtf8(word).native()) {
    if (c == L'"') text.append(slashes + 1, L'\\');
    slashes = c == L'\\' ? slashes + 1 : 0;
    text += c;
  }
  return text.append(slashes, L'\\') + L'"';
}

}  // namespace

std::uint64_t residentMemory() { return memoryCounters().WorkingSetSize; }
std::uint64_t peakMemory() { return memoryCounters().PeakWorkingSetSize; }

std::uint64_t availableMemory() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return GlobalMemoryStatusEx(&status) != 0 ? status.ullAvailPhys : 0;
}

void returnFreeMemory() {}
bool setHeap(HeapSetting /*setting*/) { return false; }

// The file inherits the access list of its folder. In folders of the user, only the user can open
// it.
unsigned createPrivate(const fs::path& file) {
  const HANDLE handle = CreateFileW(file.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW,
                                    FILE_ATTRIBUTE_NORMAL, nullptr);
  errno = handle == INVALID_HANDLE_VALUE ? errnoOfLastError() : 0;
  if (handle != INVALID_HANDLE_VALUE) CloseHandle(handle);
  return 0;
}

int flushToDisk(const fs::path& file) {
  const HANDLE handle = CreateFileW(file.c_str(), GENERIC_WRITE, FILE_SHARE_READ, nullptr,
                                    OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return 0;
  const int failed =
      FlushFileBuffers(handle) == 0 && GetLastError() == ERROR_DISK_FULL ? ENOSPC : 0;
  CloseHandle(handle);
  return failed;
}

bool mayWrite(const fs::path& file) { return _waccess(file.c_str(), 2) == 0; }
bool mayRead(const fs::path& file) { return _waccess(file.c_str(), 4) == 0; }

std::FILE* openFile(const fs::path& file, const char* mode) {
  return _wfopen(file.c_str(), std::wstring(mode, mode + std::strlen(mode)).c_str());
}

std::vector<std::string> commandLine(int argc, char** argv) {
  for (std::FILE* stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
  SetConsoleOutputCP(CP_UTF8);
  const HANDLE console = GetStdHandle(STD_ERROR_HANDLE);
  if (DWORD mode = 0; GetConsoleMode(console, &mode) != 0) {
    SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  }
  int count = 0;
  wchar_t** words = CommandLineToArgvW(GetCommandLineW(), &count);
  if (words == nullptr) return {argv + 1, argv + argc};
  std::vector<std::string> result;
  for (int i = 1; i < count; ++i) result.push_back(utf8FromWide(words[i]));
  LocalFree(static_cast<void*>(words));
  return result;
}

std::string standardInputName() { return {}; }
std::string standardOutputName() { return "CONOUT$"; }
std::string nullDeviceName() { return "NUL"; }
bool isDeviceName(const std::string& /*name*/) { return false; }
bool isTerminal(std::FILE* stream) { return _isatty(_fileno(stream)) != 0; }

void onInterrupt(void (*handler)(int)) {
  interruptHandler = handler;
  for (const int number : kInterrupts) std::signal(number, onSignal);
}
void ignoreInterrupts() {
  for (const int number : kInterrupts) std::signal(number, SIG_IGN);
}
void ignoreWriteSignals() {}

fs::path programPath() {
  std::wstring name(32768, L'\0');  // no path is longer
  name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
  return name;
}

// Windows cannot replace a program by another one. So this program waits for the other one, and
// ends with the same status.
int becomeProgram(const std::vector<std::string>& words) {
  std::vector<std::wstring> wide;
  std::vector<const wchar_t*> arguments;
  for (const std::string& word : words) wide.push_back(quoted(word));
  for (const std::wstring& word : wide) arguments.push_back(word.c_str());
  arguments.push_back(nullptr);
  const std::intptr_t status = _wspawnv(_P_WAIT, pathFromUtf8(words[0]).c_str(), arguments.data());
  if (status == -1) return errno;
  std::exit(static_cast<int>(status));
}

std::uint64_t processId() { return GetCurrentProcessId(); }

void lowerThreadPriority() { SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_BELOW_NORMAL); }

void* openLibrary(const std::string& name, std::string& why) {
  const HMODULE library = LoadLibraryW(pathFromUtf8(name).c_str());
  if (library == nullptr) why = name + ": error " + std::to_string(GetLastError());
  return reinterpret_cast<void*>(library);
}
void* symbolOf(void* library, const char* name) {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(library), name));
}

}  // namespace swept::os

#endif
