// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/three_mf.h"

#include <zlib.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <limits>
#include <new>
#include <string>
#include <vector>

namespace swept {
namespace {

constexpr std::size_t kChunk = 1U << 18U;  // bytes
constexpr int kSumAt = 14;                 // in a part's header
constexpr std::uint64_t kMax = std::numeric_limits<std::uint32_t>::max();

// Parts one after another, each packed; the list of them at the end.
class Package {
 public:
  explicit Package(std::ostream& out) : out_(out) {}
  ~Package() {
    if (open_) deflateEnd(&packer_);
  }
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  void begin(const std::string& name) {
    parts_.push_back({name, position(), 0, 0, 0});
    parts_.back().sum = static_cast<std::uint32_t>(crc32(0, nullptr, 0));
    std::string text;
    number(text, 0x04034b50, 4);
    describe(text, parts_.back());
    text += name;
    put(text);
    packer_ = {};
    // Without a header of its own, as ZIP has it.
    if (deflateInit2(&packer_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8,
                     Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
    open_ = true;
  }
  void add(const std::string& text) {
    text_ += text;
    if (text_.size() >= kChunk) pack(Z_NO_FLUSH);
  }
  void end() {
    pack(Z_FINISH);
    deflateEnd(&packer_);
    open_ = false;
    const Part& part = parts_.back();
    if (part.packed > kMax || part.bytes > kMax || position() > kMax) {
      throw Error(Status::ExportFailed, "TooManyFaces",
                  "the mesh is too large for a 3MF file, whose parts hold 4 GB; simplify it or "
                  "export PLY");
    }
    // What was not known at the start.
    std::string sums;
    number(sums, part.sum, 4);
    number(sums, part.packed, 4);
    number(sums, part.bytes, 4);
    const std::uint64_t here = position();
    out_.seekp(static_cast<std::streamoff>(part.at + kSumAt));
    put(sums);
    out_.seekp(static_cast<std::streamoff>(here));
  }
  void finish() {
    const std::uint64_t from = position();
    std::string list;
    for (const Part& part : parts_) {
      number(list, 0x02014b50, 4);
      number(list, 20, 2);  // made by version 2.0
      describe(list, part);
      number(list, 0, 2);  // comment
      number(list, 0, 4);  // disk, kind of text
      number(list, 0, 4);  // attributes
      number(list, part.at, 4);
      list += part.name;
    }
    const std::uint64_t bytes = list.size();
    number(list, 0x06054b50, 4);
    number(list, 0, 4);  // disks
    number(list, parts_.size(), 2);
    number(list, parts_.size(), 2);
    number(list, bytes, 4);
    number(list, from, 4);
    number(list, 0, 2);  // comment
    put(list);
  }

 private:
  struct Part {
    std::string name;
    std::uint64_t at = 0, packed = 0, bytes = 0;
    std::uint32_t sum = 0;
  };

  static void number(std::string& text, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xFFU);
  }
  // What both headers of a part have in the middle.
  static void describe(std::string& text, const Part& part) {
    number(text, 20, 2);      // version 2.0
    number(text, 0, 2);       // flags
    number(text, 8, 2);       // deflated
    number(text, 0, 2);       // time
    number(text, 0x0021, 2);  // 1 January 1980: the same mesh gives the same file
    number(text, part.sum, 4);
    number(text, part.packed, 4);
    number(text, part.bytes, 4);
    number(text, part.name.size(), 2);
    number(text, 0, 2);  // extra field
  }
  std::uint64_t position() { return static_cast<std::uint64_t>(out_.tellp()); }
  void put(const std::string& text) {
    out_.write(text.data(), static_cast<std::streamsize>(text.size()));
  }

  void pack(int flush) {
    Part& part = parts_.back();
    const auto size = static_cast<uInt>(text_.size());
    auto* bytes = reinterpret_cast<Bytef*>(text_.data());
    part.sum = static_cast<std::uint32_t>(crc32(part.sum, bytes, size));
    part.bytes += size;
    packer_.next_in = bytes;
    packer_.avail_in = size;
    do {
      packer_.next_out = reinterpret_cast<Bytef*>(packed_.data());
      packer_.avail_out = static_cast<uInt>(packed_.size());
      deflate(&packer_, flush);
      const std::size_t made = packed_.size() - packer_.avail_out;
      part.packed += made;
      out_.write(packed_.data(), static_cast<std::streamsize>(made));
    } while (packer_.avail_out == 0);
    text_.clear();
  }

  std::ostream& out_;
  std::vector<Part> parts_;
  std::string text_;
  std::vector<char> packed_ = std::vector<char>(kChunk);
  z_stream packer_{};
  bool open_ = false;
};

template <class Number>
void attribute(std::string& text, const char* name, Number value) {
  std::array<char, 40> digits;
  text += name;
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  text += '"';
}

void writeModel(const TriMesh& mesh, Package& package) {
  package.begin("3D/3dmodel.model");
  package.add(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>\n"
      "<object id=\"1\" type=\"model\">\n<mesh>\n<vertices>\n");
  std::string line;
  for (const Eigen::Vector3d& p : mesh.vertices) {
    line = "<vertex";
    attribute(line, " x=\"", p.x());
    attribute(line, " y=\"", p.y());
    attribute(line, " z=\"", p.z());
    package.add(line += "/>\n");
  }
  package.add("</vertices>\n<triangles>\n");
  for (const auto& triangle : mesh.triangles) {
    line = "<triangle";
    attribute(line, " v1=\"", triangle[0]);
    attribute(line, " v2=\"", triangle[1]);
    attribute(line, " v3=\"", triangle[2]);
    package.add(line += "/>\n");
  }
  package.add(
      "</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"1\"/>\n</build>\n"
      "</model>\n");
  package.end();
}

}  // namespace

void writeThreeMf(const TriMesh& mesh, std::ostream& out) {
  Package package(out);
  package.begin("[Content_Types].xml");
  package.add(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
      "<Default Extension=\"rels\" "
      "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
      "<Default Extension=\"model\" "
      "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n");
  package.end();
  package.begin("_rels/.rels");
  package.add(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n");
  package.end();
  writeModel(mesh, package);
  package.finish();
}

}  // namespace swept
