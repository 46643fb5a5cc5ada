#pragma once

// Reads main.xml of an X3P file (ISO 5436-2): axes, sizes, and the names of the
// other members of the archive. It is the only user of pugixml in this module.

#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// One axis of Record1. A coordinate is offset + increment * n, where n is the
/// number of the point or, if the axis is absolute, the stored number.
struct X3pAxis {
  bool is_absolute = false;
  char type = 'D';        ///< I, L, F or D: int16, int32, float or double
  double increment = 1.0; ///< [m] > 0
  double offset = 0.0;    ///< [m]

  /// Size of a stored number; 0 if the axis is not absolute.
  std::size_t stored_bytes() const {
    if (!is_absolute)
      return 0;
    return type == 'I' ? 2 : type == 'D' ? 8 : 4;
  }
};

struct X3pHeader {
  X3pAxis x, y, z; ///< z is absolute
  std::int64_t size_x = 0;
  std::int64_t size_y = 0;
};

class X3pDocument {
public:
  /// @param name  of the X3P file, for messages
  /// @throws input::InputError  the text is no XML
  X3pDocument(const std::string& text, std::string name);

  /// @throws input::InputError  the file is no surface with one layer, or an
  ///                            entry is missing or malformed
  X3pHeader header() const;

  /// The text of an entry such as "Record3/DataLink/PointDataLink", whatever
  /// the namespace prefixes; "" if there is none.
  std::string text_at(std::string_view path) const;

  /// The texts of the entries of an element; empty if there is none.
  std::vector<std::string> texts_in(std::string_view path) const;

  /// @throws input::InputError  "name: main.xml: what"
  [[noreturn]] void refuse(const std::string& what) const;

private:
  pugi::xml_node node_at(std::string_view path) const;
  std::string needed_text(const std::string& path) const;
  double number_at(const std::string& path, double otherwise) const;
  std::int64_t count_at(const std::string& path) const;
  X3pAxis axis(const std::string& name) const;

  pugi::xml_document document_;
  std::string name_;
};

} // namespace asperity::surfaces
