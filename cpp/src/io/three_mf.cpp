// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/three_mf.h"

#include <minizip/zip.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <system_error>

#include "base/safe_file.h"
#include "base/system.h"

namespace swept {
namespace {

// The text is compressed in pieces of at least this many bytes.
constexpr std::size_t kChunk = 1U << 18U;
// Upper bound of the characters in a line of the model: XML and three numbers of up to 25
// characters.
constexpr std::uint64_t kMaxLine = 110;

// Writes a ZIP file through minizip: several compressed entries, one after another.
class Package {
 public:
  explicit Package(const std::string& path) {
    zlib_filefunc64_def functions{};
    fill_fopen64_filefunc(&functions);
    functions.zopen64_file = openForWriting;
    zip_ = zipOpen2_64(path.c_str(), APPEND_STATUS_CREATE, nullptr, &functions);
    check(zip_ != nullptr);
  }
  ~Package() {
    if (zip_ != nullptr) zipClose(zip_, nullptr);
  }
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  /// Begins an entry. `mostBytes`: upper bound of its size, required if it may exceed 4 GB.
  void begin(const char* name, std::uint64_t mostBytes = 0) {
    zip_fileinfo information{};
    information.tmz_date.tm_mday = 1;  // 1 January 1980, so that equal meshes give equal files
    information.tmz_date.tm_year = 1980;
    const int large = mostBytes > std::numeric_limits<std::uint32_t>::max() ? 1 : 0;
    check(zipOpenNewFileInZip64(zip_, name, &information, nullptr, 0, nullptr, 0, nullptr,
                                Z_DEFLATED, Z_DEFAULT_COMPRESSION, large) == ZIP_OK);
  }
  void add(const std::string& text) {
    text_ += text;
    if (text_.size() >= kChunk) pack();
  }
  void end() {
    pack();
    check(zipCloseFileInZip(zip_) == ZIP_OK);
  }
  void finish() {
    const zipFile zip = zip_;
    zip_ = nullptr;
    check(zipClose(zip, nullptr) == ZIP_OK);
  }

 private:
  // Replaces minizip's own open function, which does not treat names as UTF-8 on every system.
  static void* openForWriting(void* /*opaque*/, const void* name, int /*mode*/) {
    return os::openFile(pathFromUtf8(static_cast<const char*>(name)), "wb");
  }
  static void check(bool done) {
    if (done) return;
    throw Error(Status::ExportFailed, "WriteFailed",
                "writing the 3MF file failed: " +
                    (errno != 0 ? std::system_category().message(errno) : "unknown cause") +
                    "; an old file of this name is unchanged");
  }
  void pack() {
    errno = 0;
    check(zipWriteInFileInZip(zip_, text_.data(), static_cast<unsigned>(text_.size())) == ZIP_OK);
    text_.clear();
  }

  zipFile zip_ = nullptr;
  std::string text_;
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
  package.begin("3D/3dmodel.model", kMaxLine * (mesh.vertices.size() + mesh.triangles.size() + 10));
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

void writeThreeMf(const TriMesh& mesh, const std::string& path) {
  Package package(path);
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
