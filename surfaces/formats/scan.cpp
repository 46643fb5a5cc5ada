#include "surfaces/formats/scan.hpp"

#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "results/trial_read.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/scan_formats.hpp"

#include <fmt/format.h>

#include <utility>

namespace asperity::surfaces {
namespace {

using mechanics::MapFormat;

/// Formats whose only reader yields rows of a file.
bool is_read_by_rows(MapFormat format) {
  return format == MapFormat::sur || format == MapFormat::wsxm;
}

/// Formats that read_scan_bytes reads by itself.
bool is_read_from_bytes(MapFormat format) {
  return format != MapFormat::hdf5 && format != MapFormat::convert &&
         !is_read_by_rows(format);
}

bool is_text(MapFormat format) {
  return format == MapFormat::automatic || format == MapFormat::plain ||
         format == MapFormat::gwyddion || format == MapFormat::xyz;
}

MapFormat format_of(std::string_view bytes, const ScanRequest& request) {
  return request.format == MapFormat::automatic ? recognised_format(bytes)
                                                : request.format;
}

/// All rows of a file.
Scan scan_of_rows(const RowFile& file, const std::string& name) {
  Scan scan{{file.grid, file.rows(0, file.grid.points_y)},
            {},
            file.channel,
            file.reader,
            file.numbers};
  mark_missing(scan, name);
  return scan;
}

/// The points that have the number of missing ones are missing.
Scan without_missing_value(Scan scan, const ScanRequest& request,
                           const std::string& name) {
  mark_missing_value(scan.map.heights, scan.numbers, request.missing_value);
  mark_missing(scan, name);
  return scan;
}

Scan scan_of_bytes(std::string_view bytes, const std::string& name,
                   const ScanRequest& request, MapFormat format) {
  if (format == MapFormat::gwy)
    return read_gwy_file(bytes, name, request, Asked::scan).scan;
  Scan scan;
  if (is_text(format))
    scan = read_text_scan(bytes, name, request);
  else if (format == MapFormat::npy)
    scan = read_npy_scan(bytes, name, request);
  else {
    refuse_scale(request.scale, name);
    scan = format == MapFormat::sdf ? read_sdf_scan(bytes, name)
                                    : read_x3p_scan(bytes, name);
  }
  refuse_channel(request, scan.channel, name);
  return scan;
}

FileContent read_file_of(const std::string& path, const ScanRequest& request,
                         Asked asked) {
  const std::string bytes =
      input::read_input_file(path, input::largest_number_file);
  const MapFormat format = format_of(bytes, request);
  if (format == MapFormat::hdf5) {
    // The packaged library has memory errors that a damaged file can trigger.
    results::require_readable(
        path, [&] { (void)read_hdf5_file(path, request, asked); });
    return read_hdf5_file(path, request, asked);
  }
  if (format == MapFormat::convert)
    return read_converted_file(path, request, asked);
  if (format == MapFormat::gwy)
    return read_gwy_file(bytes, path, request, asked);
  FileContent content;
  if (asked == Asked::channels && is_text(format)) {
    content.channels = {text_channel(bytes, path)};
    return content;
  }
  if (asked == Asked::channels && format == MapFormat::npy) {
    content.channels = {npy_channel(bytes, path)};
    return content;
  }
  content.scan = is_read_by_rows(format)
                     ? scan_of_rows(row_file(path, request).value(), path)
                     : scan_of_bytes(bytes, path, request, format);
  const Grid& grid = content.scan.map.grid;
  content.channels.push_back(
      {content.scan.channel, "m", grid.points_x, grid.points_y});
  return content;
}

} // namespace

bool names_another(const std::optional<std::string>& wanted,
                   const std::string& title) {
  return wanted && *wanted != title && *wanted != "1";
}

Scan read_scan_bytes(std::string_view bytes, const std::string& name,
                     const ScanRequest& request) {
  const MapFormat format = format_of(bytes, request);
  if (!is_read_from_bytes(format))
    throw input::InputError(name + ": this format is read from files only");
  return without_missing_value(scan_of_bytes(bytes, name, request, format),
                               request, name);
}

Scan read_scan(const std::string& path, const ScanRequest& request) {
  return without_missing_value(read_file_of(path, request, Asked::scan).scan,
                               request, path);
}

std::vector<ChannelInfo> list_channels(const std::string& path) {
  return read_file_of(path, {}, Asked::channels).channels;
}

} // namespace asperity::surfaces
