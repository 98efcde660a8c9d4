// Functions of the operating system that the C++ library lacks. Only their implementation
// (system*.cpp) calls POSIX, Linux, macOS or Windows (checked by tests/tools/include_rules.py).
// Names of files are UTF-8 or std::filesystem::path on every system.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace swept::os {

// --- memory, in bytes; 0 if the system does not say

/// Returns the resident size of the process. Allocates nothing in Linux, since it is also called
/// when the memory may be exhausted.
std::uint64_t residentMemory();
/// Returns the largest resident size that the process ever had.
std::uint64_t peakMemory();
/// Returns the memory that the process can take without swapping.
std::uint64_t availableMemory();
/// Returns free memory to the system, if the C library has a call for that.
void returnFreeMemory();
/// Where malloc() takes memory from. OneHeap: only from the heap; free memory at its end is not
/// returned to the system. KeepFree: from anywhere; free memory at the end of the heap is still not
/// returned. Usual: the defaults of the C library.
enum class HeapSetting { OneHeap, KeepFree, Usual };
/// Returns false if the C library has no such settings.
bool setHeap(HeapSetting setting);

// --- files

/// Creates a new file that only its owner may read (where the system has modes). Never opens a file
/// that exists already, nor the target of a link. Returns the mode that new files in this folder
/// usually get; 0 if the system has no modes or the file could not be created. Sets errno, to 0 if
/// the file was created.
unsigned createPrivate(const std::filesystem::path& file);
/// Flushes the file to the disk, because some systems report a full disk only then. Returns 0, or
/// the errno if the data could not be written. Also returns 0 if the file cannot be opened again,
/// or if its file system cannot flush.
int flushToDisk(const std::filesystem::path& file);
/// Returns whether the user may write to an existing file or read it. Sets errno if not.
bool mayWrite(const std::filesystem::path& file);
bool mayRead(const std::filesystem::path& file);
/// Does the same as std::fopen(), for any path.
std::FILE* openFile(const std::filesystem::path& file, const char* mode);

/// A temporary file for a copy of data that can be read only once. Only its owner may read it. It
/// disappears with this object; in Linux it has no name from the start, and also disappears if the
/// process is killed.
class ScratchFile {
 public:
  ScratchFile();  ///< throws std::system_error
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  void write(const char* bytes, std::size_t count);  ///< throws std::system_error
  /// Flushes the file, and returns a name by which it can be opened for reading.
  std::string finish();

 private:
  std::filesystem::path name_;
  std::FILE* file_ = nullptr;
};
/// Creates an empty file with an unused name in the folder for temporary files. Only its owner may
/// read it. Throws std::system_error.
std::filesystem::path newTemporaryFile(const std::string& suffix);

// --- the program, its terminal and its signals

/// Returns the words of the command line, in UTF-8. Also prepares the standard streams, so that
/// Windows does not change the bytes that are read or written.
std::vector<std::string> commandLine(int argc, char** argv);
/// Returns a name by which standard input can be opened; empty if there is none.
std::string standardInputName();
/// Returns a name by which standard output can be opened.
std::string standardOutputName();
/// Returns the name of the null device, which discards everything that is written to it.
std::string nullDeviceName();
/// Returns true for names that may lead to a terminal, a pipe or any other file without a suffix.
bool isDeviceName(const std::string& name);
bool isTerminal(std::FILE* stream);
/// Calls handler(number) at each signal that asks the program to end (SIGINT, SIGTERM, SIGHUP),
/// instead of ending it. If the program was started with nohup, SIGHUP stays ignored. In Windows,
/// the third signal is SIGBREAK.
void onInterrupt(void (*handler)(int));
/// Ignores these signals from now on.
void ignoreInterrupts();
/// Ignores the signals of failed writes. On a closed pipe or at a limit of the file size, the write
/// then fails with an error, instead of ending the program.
void ignoreWriteSignals();
/// Returns the file of the running program; empty if not known.
std::filesystem::path programPath();
/// Replaces this program by another one. In Windows, runs the other program and then ends with its
/// exit status. Returns only after a failure, with the errno.
int becomeProgram(const std::vector<std::string>& words);
std::uint64_t processId();

// --- the calling thread, and libraries

/// Lowers the priority of the calling thread below that of other threads. Has no effect if the
/// system refuses.
void lowerThreadPriority();
/// Loads a library for the rest of the process. Returns null and the reason if that fails.
void* openLibrary(const std::string& name, std::string& why);
void* symbolOf(void* library, const char* name);  ///< null if there is none

}  // namespace swept::os
