// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/ply_mesh.h"

#include <algorithm>
#include <array>
#include <bit>

#include "base/limits.h"
#include "io/text_mesh.h"

namespace swept {
namespace {

[[noreturn]] void bad(const std::string& path, const std::string& what) {
  throw Error(Status::InvalidInput, "BadFile", "'" + path + "'" + what);
}

/// The part of the mesh that a property holds.
enum class Role { None, X, Y, Z, Corners };

Role roleOf(const PlyElement& element, const PlyProperty& property) {
  if (element.name == "vertex" && property.countBytes == 0 && property.name.size() == 1) {
    const int axis = property.name[0] - 'x';
    if (axis >= 0 && axis < 3) return static_cast<Role>(static_cast<int>(Role::X) + axis);
  }
  const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
  if (element.name == "face" && property.countBytes != 0 && corners) return Role::Corners;
  return Role::None;
}

std::vector<Role> rolesOf(const PlyElement& element) {
  std::vector<Role> roles;
  for (const PlyProperty& property : element.properties) roles.push_back(roleOf(element, property));
  return roles;
}

void requireRoles(const PlyHeader& header, const std::string& path) {
  const auto require = [&](const char* element, Role role, const char* what) {
    const std::vector<Role> roles = rolesOf(*header.find(element));
    if (std::count(roles.begin(), roles.end(), role) != 1) {
      bad(path, std::string(": the element '") + element + "' must have " + what + " exactly once");
    }
  };
  require("vertex", Role::X, "a property x");
  require("vertex", Role::Y, "a property y");
  require("vertex", Role::Z, "a property z");
  require("face", Role::Corners, "a list vertex_indices");
  for (const PlyProperty& property : header.find("face")->properties) {
    if (roleOf(*header.find("face"), property) == Role::Corners && property.isFloat) {
      bad(path, ": vertex_indices must be whole numbers");
    }
  }
  if (header.find("vertex")->count > kMaxElements) {
    bad(path, ": more than " + std::to_string(kMaxElements) + " vertices");
  }
}

/// The mesh read so far, to which the readers add one value after another.
class PolygonBuilder {
 public:
  void value(Role role, double number) { point_[static_cast<int>(role) - 1] = number; }
  void corner(std::int64_t index) {
    // An index that does not fit into 32 bits becomes -1. The later index check refuses it.
    const bool fits = index >= 0 && index <= static_cast<std::int64_t>(kMaxElements);
    list.corners.push_back(fits ? static_cast<std::int32_t>(index) : -1);
  }
  void endOf(const PlyElement& element) {
    if (element.name == "vertex") list.vertices.push_back(point_);
    if (element.name == "face") list.faceStart.push_back(list.corners.size());
  }

  PolygonList list;

 private:
  Eigen::Vector3d point_ = Eigen::Vector3d::Zero();
};

/// Reads the bytes of a binary file in order, through its own buffer.
class BinaryRows {
 public:
  BinaryRows(std::istream& stream, const PlyHeader& header, std::uint64_t fileBytes)
      : stream_(stream),
        left_(fileBytes - header.dataStart),
        big_(header.format == PlyHeader::Format::BigEndian) {
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(header.dataStart));
  }

  /// Returns the number of bytes of the file that have not been taken yet.
  std::uint64_t left() const { return left_; }

  /// Takes `count` bytes as one number. Returns false if the file has too few bytes.
  bool take(int count, std::uint64_t& bits) {
    if (static_cast<std::uint64_t>(count) > left_ || !fill(count)) return false;
    bits = 0;
    for (int i = 0; i < count; ++i)
      bits = bits << 8 | buffer_[at_ + static_cast<std::size_t>(big_ ? i : count - 1 - i)];
    at_ += static_cast<std::size_t>(count);
    left_ -= static_cast<std::uint64_t>(count);
    return true;
  }

 private:
  bool fill(int count) {
    const auto wanted = static_cast<std::size_t>(count);
    if (end_ - at_ >= wanted) return true;
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(at_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= at_;
    at_ = 0;
    stream_.read(reinterpret_cast<char*>(buffer_.data() + end_),
                 static_cast<std::streamsize>(buffer_.size() - end_));
    end_ += static_cast<std::size_t>(stream_.gcount());
    return end_ >= wanted;
  }

  std::istream& stream_;
  std::uint64_t left_;
  bool big_;
  std::array<unsigned char, 1 << 16> buffer_;
  std::size_t at_ = 0, end_ = 0;
};

std::int64_t wholeOf(std::uint64_t bits, const PlyProperty& property) {
  const int unused = 64 - 8 * property.bytes;
  if (!property.isSigned) return static_cast<std::int64_t>(bits);
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

double numberOf(std::uint64_t bits, const PlyProperty& property) {
  if (!property.isFloat) return static_cast<double>(wholeOf(bits, property));
  if (property.bytes == 8) return std::bit_cast<double>(bits);
  return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
}

void readBinaryElement(BinaryRows& rows, const PlyElement& element, PolygonBuilder& mesh,
                       const std::string& path) {
  const std::vector<Role> roles = rolesOf(element);
  std::uint64_t i = 0;
  const auto take = [&](int bytes) {
    std::uint64_t bits = 0;
    if (rows.take(bytes, bits)) return bits;
    bad(path, " ends inside " + element.name + " " + std::to_string(i) + " of " +
                  std::to_string(element.count) + "; the file is truncated");
  };
  for (; i < element.count; ++i) {
    for (std::size_t k = 0; k < roles.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (property.countBytes == 0) {
        const std::uint64_t bits = take(property.bytes);
        if (roles[k] != Role::None) mesh.value(roles[k], numberOf(bits, property));
        continue;
      }
      const std::uint64_t entries = take(property.countBytes);
      if (entries > rows.left() / static_cast<std::uint64_t>(property.bytes)) {
        bad(path, ": " + element.name + " " + std::to_string(i) + " declares " +
                      std::to_string(entries) +
                      " entries, more than the file can hold; it is damaged or truncated");
      }
      for (std::uint64_t n = 0; n < entries; ++n) {
        const std::uint64_t bits = take(property.bytes);
        if (roles[k] == Role::Corners) mesh.corner(wholeOf(bits, property));
      }
    }
    mesh.endOf(element);
  }
}

void readTextElement(TextScanner& scan, std::size_t textBytes, const PlyElement& element,
                     PolygonBuilder& mesh) {
  const std::vector<Role> roles = rolesOf(element);
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (std::size_t k = 0; k < roles.size(); ++k) {
      if (element.properties[k].countBytes == 0) {
        const double number = toNumber(scan, scan.wordAnywhere());
        if (roles[k] != Role::None) mesh.value(roles[k], number);
        continue;
      }
      const std::int64_t entries = toInteger(scan, scan.wordAnywhere());
      if (entries < 0 || entries > static_cast<std::int64_t>(textBytes)) {
        scan.bad("a list of " + std::to_string(entries) +
                 " entries is not possible; the file is damaged");
      }
      for (std::int64_t n = 0; n < entries; ++n) {
        if (roles[k] == Role::Corners) {
          mesh.corner(toInteger(scan, scan.wordAnywhere()));
        } else {
          toNumber(scan, scan.wordAnywhere());
        }
      }
    }
    mesh.endOf(element);
  }
}

}  // namespace

PolygonList readPlyMesh(std::istream& stream, const PlyHeader& header, std::uint64_t fileBytes,
                        const std::string& path) {
  requireRoles(header, path);
  PolygonBuilder mesh;
  const auto each = [&](const auto& read) {
    for (const PlyElement& element : header.elements) {
      if (!element.properties.empty()) read(element);
    }
  };
  if (header.format == PlyHeader::Format::Ascii) {
    const std::string text = readAll(stream);
    TextScanner scan(std::string_view(text).substr(header.dataStart), path, header.lines + 1);
    each([&](const PlyElement& e) { readTextElement(scan, text.size(), e, mesh); });
  } else {
    BinaryRows rows(stream, header, fileBytes);
    each([&](const PlyElement& e) { readBinaryElement(rows, e, mesh, path); });
  }
  return std::move(mesh.list);
}

}  // namespace swept
