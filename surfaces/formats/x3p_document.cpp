#include "surfaces/formats/x3p_document.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/length_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace asperity::surfaces {
namespace {

/// The first child with this name, whatever its namespace prefix.
pugi::xml_node child_named(const pugi::xml_node& parent,
                           std::string_view name) {
  for (const pugi::xml_node& node : parent.children()) {
    const std::string_view full = node.name();
    if (full.substr(full.rfind(':') + 1) == name)
      return node;
  }
  return {};
}

} // namespace

X3pDocument::X3pDocument(const std::string& text, std::string name)
    : name_(std::move(name)) {
  const pugi::xml_parse_result parsed =
      document_.load_buffer(text.data(), text.size());
  if (!parsed)
    refuse(fmt::format("byte {}: is no XML ({})", parsed.offset,
                       parsed.description()));
}

void X3pDocument::refuse(const std::string& what) const {
  throw input::InputError(fmt::format("{}: main.xml: {}", name_, what));
}

pugi::xml_node X3pDocument::node_at(std::string_view path) const {
  pugi::xml_node node = document_.document_element();
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    node = child_named(node, path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return node;
}

std::string X3pDocument::text_at(std::string_view path) const {
  return trimmed(node_at(path).child_value());
}

std::vector<std::string> X3pDocument::texts_in(std::string_view path) const {
  std::vector<std::string> texts;
  for (const pugi::xml_node& node : node_at(path).children())
    texts.push_back(trimmed(node.child_value()));
  return texts;
}

std::string X3pDocument::needed_text(const std::string& path) const {
  std::string text = text_at(path);
  if (text.empty())
    refuse("there is no " + path);
  return text;
}

double X3pDocument::number_at(const std::string& path, double otherwise) const {
  const std::string text = text_at(path);
  if (text.empty())
    return otherwise;
  const double number = number_of_text(text);
  if (!std::isfinite(number))
    refuse(fmt::format("{} is '{}', but must be a finite number", path,
                       printable(text)));
  return number;
}

std::int64_t X3pDocument::count_at(const std::string& path) const {
  const std::string text = needed_text(path);
  std::int64_t number = 0;
  const auto [stop, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || stop != text.data() + text.size())
    refuse(fmt::format("{} is '{}', but must be a whole number", path,
                       printable(text)));
  return number;
}

X3pAxis X3pDocument::axis(const std::string& name) const {
  const std::string path = "Record1/Axes/" + name;
  X3pAxis axis;
  const std::string kind = needed_text(path + "/AxisType");
  if (kind != "A" && kind != "I")
    refuse(fmt::format("{}/AxisType is '{}', but must be A (absolute) or I "
                       "(incremental)",
                       path, printable(kind)));
  axis.is_absolute = kind == "A";
  const std::string type =
      axis.is_absolute ? needed_text(path + "/DataType") : "D";
  if (type != "I" && type != "L" && type != "F" && type != "D")
    refuse(fmt::format("{}/DataType is '{}', but must be I, L, F or D", path,
                       printable(type)));
  axis.type = type[0];
  axis.increment = number_at(path + "/Increment", 1.0);
  axis.offset = number_at(path + "/Offset", 0.0);
  if (axis.increment <= 0.0)
    refuse(fmt::format("{}/Increment is {:.6g} m, but must be > 0", path,
                       axis.increment));
  return axis;
}

X3pHeader X3pDocument::header() const {
  const std::string feature = needed_text("Record1/FeatureType");
  if (feature != "SUR")
    refuse(fmt::format("Record1/FeatureType is '{}', but must be SUR, a "
                       "surface; profiles and point clouds are no maps",
                       printable(feature)));
  X3pHeader header;
  header.x = axis("CX");
  header.y = axis("CY");
  header.z = axis("CZ");
  if (!header.z.is_absolute)
    refuse("the axis CZ must be absolute (A)");
  if (!node_at("Record3/MatrixDimension"))
    refuse("there is no MatrixDimension: the points are a list, not a map");
  header.size_x = count_at("Record3/MatrixDimension/SizeX");
  header.size_y = count_at("Record3/MatrixDimension/SizeY");
  if (const auto layers = count_at("Record3/MatrixDimension/SizeZ");
      layers != 1)
    refuse(fmt::format("Record3/MatrixDimension/SizeZ is {}, but must be 1",
                       layers));
  return header;
}

} // namespace asperity::surfaces
