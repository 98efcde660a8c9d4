// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/process.h"

#include <csignal>
#include <cstring>
#include <new>

#ifdef _WIN32
#include <windows.h>
#else
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace swept::test {

#ifdef _WIN32

bool isSuperuser() { return false; }

bool FileSizeLimit::available() { return false; }
FileSizeLimit::FileSizeLimit(std::uint64_t /*bytes*/) {}
FileSizeLimit::~FileSizeLimit() = default;

bool FileModeMask::available() { return false; }
FileModeMask::FileModeMask(unsigned /*mask*/) {}
FileModeMask::~FileModeMask() = default;

ResidentPages::ResidentPages(std::size_t bytes)
    : bytes_(bytes), at_(VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE)) {
  if (at_ == nullptr) throw std::bad_alloc();
  std::memset(at_, 1, bytes_);
}
ResidentPages::~ResidentPages() { VirtualFree(at_, 0, MEM_RELEASE); }

#else

bool isSuperuser() { return ::geteuid() == 0; }

bool FileSizeLimit::available() { return true; }
FileSizeLimit::FileSizeLimit(std::uint64_t bytes) {
  struct rlimit limit {};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  before_ = limit.rlim_cur;
  handler_ = std::signal(SIGXFSZ, SIG_IGN);
  limit.rlim_cur = bytes;
  ::setrlimit(RLIMIT_FSIZE, &limit);
}
FileSizeLimit::~FileSizeLimit() {
  struct rlimit limit {};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = before_;
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler_);
}

bool FileModeMask::available() { return true; }
FileModeMask::FileModeMask(unsigned mask) : old_(::umask(static_cast<mode_t>(mask))) {}
FileModeMask::~FileModeMask() { ::umask(static_cast<mode_t>(old_)); }

ResidentPages::ResidentPages(std::size_t bytes)
    : bytes_(bytes),
      at_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
  if (at_ == MAP_FAILED) throw std::bad_alloc();
  std::memset(at_, 1, bytes_);
}
ResidentPages::~ResidentPages() { munmap(at_, bytes_); }

#endif

}  // namespace swept::test
