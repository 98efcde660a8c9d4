// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/line_source.h"

#include <lzma.h>
#include <zlib.h>

#include <array>
#include <cstring>
#include <istream>
#include <vector>

#include "io/input_file.h"
#include "swept/types.h"

namespace swept {
namespace {

constexpr std::size_t kChunkBytes = 1 << 16;

class PlainSource final : public ByteSource {
 public:
  PlainSource(const std::string& path, std::unique_ptr<std::istream> stream)
      : path_(path), stream_(std::move(stream)) {}
  std::size_t read(char* buffer, std::size_t capacity) override {
    stream_->read(buffer, static_cast<std::streamsize>(capacity));
    if (stream_->bad())
      badFile("'" + path_ + "' cannot be read to its end; check the disk or the connection");
    return static_cast<std::size_t>(stream_->gcount());
  }

 private:
  std::string path_;
  std::unique_ptr<std::istream> stream_;
};

class GzipSource final : public ByteSource {
 public:
  GzipSource(const std::string& path, std::unique_ptr<std::istream> stream)
      : path_(path), stream_(std::move(stream)), packed_(kChunkBytes) {
    constexpr int kGzipWindow = 15 + 16;
    if (inflateInit2(&state_, kGzipWindow) != Z_OK) throw std::bad_alloc();
  }
  ~GzipSource() override { inflateEnd(&state_); }
  GzipSource(const GzipSource&) = delete;
  GzipSource& operator=(const GzipSource&) = delete;

  std::size_t read(char* buffer, std::size_t capacity) override {
    state_.next_out = reinterpret_cast<Bytef*>(buffer);
    state_.avail_out = static_cast<uInt>(capacity);
    while (state_.avail_out == capacity) {
      if (state_.avail_in == 0) {
        stream_->read(packed_.data(), static_cast<std::streamsize>(packed_.size()));
        state_.next_in = reinterpret_cast<Bytef*>(packed_.data());
        state_.avail_in = static_cast<uInt>(stream_->gcount());
        if (state_.avail_in == 0 && ended_) return 0;
        if (state_.avail_in == 0)
          badFile("'" + path_ + "' is truncated (gzip); compress or copy it again");
      }
      if (ended_) {  // a gzip file may consist of several members
        inflateReset(&state_);
        ended_ = false;
      }
      const int code = inflate(&state_, Z_NO_FLUSH);
      if (code == Z_STREAM_END) {
        ended_ = true;
      } else if (code != Z_OK) {
        badFile("'" + path_ +
                "' is damaged (gzip: " + (state_.msg != nullptr ? state_.msg : "wrong data") +
                "); compress or copy it again");
      }
    }
    return capacity - state_.avail_out;
  }

 private:
  std::string path_;
  std::unique_ptr<std::istream> stream_;
  std::vector<char> packed_;
  z_stream state_{};
  bool ended_ = false;
};

class XzSource final : public ByteSource {
 public:
  XzSource(const std::string& path, std::unique_ptr<std::istream> stream)
      : path_(path), stream_(std::move(stream)), packed_(kChunkBytes) {
    constexpr std::uint64_t kMemory = 256ULL << 20;
    if (lzma_stream_decoder(&state_, kMemory, LZMA_CONCATENATED) != LZMA_OK) throw std::bad_alloc();
  }
  ~XzSource() override { lzma_end(&state_); }
  XzSource(const XzSource&) = delete;
  XzSource& operator=(const XzSource&) = delete;

  std::size_t read(char* buffer, std::size_t capacity) override {
    if (ended_) return 0;
    state_.next_out = reinterpret_cast<std::uint8_t*>(buffer);
    state_.avail_out = capacity;
    while (state_.avail_out == capacity && !ended_) {
      if (state_.avail_in == 0 && *stream_) {
        stream_->read(packed_.data(), static_cast<std::streamsize>(packed_.size()));
        state_.next_in = reinterpret_cast<const std::uint8_t*>(packed_.data());
        state_.avail_in = static_cast<std::size_t>(stream_->gcount());
      }
      const lzma_ret code = lzma_code(&state_, *stream_ ? LZMA_RUN : LZMA_FINISH);
      if (code == LZMA_STREAM_END) {
        ended_ = true;
      } else if (code == LZMA_BUF_ERROR) {
        badFile("'" + path_ + "' is truncated (xz); compress or copy it again");
      } else if (code != LZMA_OK) {
        badFile("'" + path_ + "' is damaged (xz, code " + std::to_string(code) +
                "); compress or copy it again");
      }
    }
    return capacity - state_.avail_out;
  }

 private:
  std::string path_;
  std::unique_ptr<std::istream> stream_;
  std::vector<char> packed_;
  lzma_stream state_ = LZMA_STREAM_INIT;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<ByteSource> openByteSource(const std::string& path) {
  std::unique_ptr<std::istream> stream = openInput(path).stream;
  std::array<char, 6> head{};
  stream->read(head.data(), head.size());
  const auto got = stream->gcount();
  stream->clear();
  stream->seekg(0);
  if (got >= 2 && std::memcmp(head.data(), "\x1f\x8b", 2) == 0) {
    return std::make_unique<GzipSource>(path, std::move(stream));
  }
  if (got == 6 && std::memcmp(head.data(),
                              "\xfd"
                              "7zXZ\0",
                              6) == 0) {
    return std::make_unique<XzSource>(path, std::move(stream));
  }
  return std::make_unique<PlainSource>(path, std::move(stream));
}

LineSource::LineSource(const std::string& path) : path_(path), source_(openByteSource(path)) {
  while (buffer_.size() < 3 && fill()) {
  }
  if (buffer_.compare(0, 3, "\xef\xbb\xbf") == 0) at_ = 3;
  if (buffer_.compare(0, 2, "\xff\xfe") == 0 || buffer_.compare(0, 2, "\xfe\xff") == 0) {
    badFile("'" + path_ + "' is written in UTF-16; save it as UTF-8 or plain text");
  }
}

bool LineSource::fill() {
  const std::size_t old = buffer_.size();
  buffer_.resize(old + kChunkBytes);
  const std::size_t got = source_->read(buffer_.data() + old, kChunkBytes);
  buffer_.resize(old + got);
  total_ += got;
  if (total_ > kMaxTextBytes) {
    throw Error(Status::ResourceLimit, "FileTooLarge",
                "'" + path_ + "' contains more than " + std::to_string(kMaxTextBytes >> 30) +
                    " GiB of text when uncompressed; reduce the number of poses");
  }
  return got != 0;
}

bool LineSource::next(std::string& line) {
  std::size_t end = buffer_.find('\n', at_);
  while (end == std::string::npos) {
    buffer_.erase(0, at_);
    at_ = 0;
    const std::size_t searched = buffer_.size();
    if (searched > kMaxLineBytes) {
      badFile("'" + path_ + "', line " + std::to_string(number_ + 1) + " is longer than " +
              std::to_string(kMaxLineBytes) +
              " bytes, so the file is not a table of poses; choose a text file with one pose per "
              "line");
    }
    if (!fill()) break;
    end = buffer_.find('\n', searched);
  }
  if (end == std::string::npos && at_ >= buffer_.size()) return false;
  const std::size_t stop = end == std::string::npos ? buffer_.size() : end;
  line.assign(buffer_, at_, stop - at_);
  at_ = end == std::string::npos ? stop : stop + 1;
  ++number_;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  const std::size_t nul = line.find('\0');
  if (nul != std::string::npos) {
    badFile("'" + path_ + "', line " + std::to_string(number_) + ", byte " +
            std::to_string(nul + 1) + ": a zero byte; the file is damaged, or is not a text file");
  }
  return true;
}

}  // namespace swept
