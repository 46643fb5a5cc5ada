#include "run/plan/finished_output.hpp"

#include "base/atomic_file.hpp"
#include "base/child_process.hpp"
#include "base/content_hash.hpp"
#include "base/json.hpp"
#include "base/read_file.hpp"
#include "methods/cache/case_keys.hpp"
#include "methods/chosen.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <system_error>

namespace asperity::run {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* list_name = "output.json";

/// Largest part of the cache that one output may take: maps on large grids
/// would replace the steps of many other cases.
constexpr std::uintmax_t smallest_number_of_outputs = 10;

/// Passes the bytes of a file on by pieces.
BytePieces pieces_of(const fs::path& file) {
  return [file](const TakeBytes& take) {
    std::ifstream stream(file, std::ios::binary);
    std::string piece(std::size_t{1} << 20, '\0');
    while (
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) ||
        stream.gcount() > 0)
      take(std::string_view(piece).substr(
          0, static_cast<std::size_t>(stream.gcount())));
  };
}

/// Identifies the program that draws the figures: equal texts draw equal bytes.
std::string drawing_program() {
  const fs::path path = program_on_path("gnuplot");
  std::error_code error;
  const auto size = fs::file_size(path, error);
  const auto changed = fs::last_write_time(path, error);
  return error ? "none"
               : fmt::format("{} {} {}", path.string(), size,
                             changed.time_since_epoch().count());
}

bool is_listed(const fs::path& file) {
  const std::string name = file.filename().string();
  return !name.starts_with('.') && name != list_name &&
         name != "result.previous.h5" && name != "result.unfinished.h5";
}

/// The files of a list; nothing unless the cache has all of them.
std::optional<OutputFiles> listed_files(const std::string& list,
                                        methods::Cache& cache) {
  OutputFiles files;
  const Json parsed = json_of_text(list);
  for (const auto& [file, hash] : parsed.at("sha256").items()) {
    std::optional<std::string> bytes =
        cache.read(hash.get<std::string>(), methods::entry_kind::file);
    if (!bytes)
      return std::nullopt;
    files[file] = std::move(*bytes);
  }
  return files;
}

} // namespace

OutputKeys output_keys(const cases::Case& contact_case,
                       const RunOptions& options, const std::string& extras) {
  const methods::CaseKeys keys(contact_case, methods::program_identity());
  // Keys of steps leave out what a report shows: its program, the name of the
  // case, the fields that are saved.
  std::string text = methods::hash_of_file("/proc/self/exe") + "\n" +
                     drawing_program() + "\n" + extras + "\n" +
                     contact_case.name + "\n" + keys.text_of_numbers() + "\n";
  for (const cases::MethodSpec& method : methods::chosen_methods(
           contact_case, options.methods, options.is_exact)) {
    text += method.name + "\n";
    for (int r = 0; r < methods::n_realizations(contact_case, method); ++r)
      text += keys.steps(method, r).back() + "\n";
  }
  return {content_hash(text + contact_case.text + "\n" + options.reference),
          content_hash(text)};
}

void record_output(const fs::path& folder, const OutputKeys& keys,
                   std::string_view figures, methods::Cache& cache) {
  std::map<std::string, std::string> hashes;
  std::uintmax_t size = figures.size();
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_listed(entry.path())) {
      size += entry.file_size();
      hashes[fs::relative(entry.path(), folder).string()] = "";
    }
  const bool fits = size <= cache.most_bytes() / smallest_number_of_outputs;
  for (auto& [file, hash] : hashes) {
    hash = methods::hash_of_file(folder / file);
    if (fits && !cache.has(hash, methods::entry_kind::file))
      cache.write(hash, methods::entry_kind::file, fs::file_size(folder / file),
                  pieces_of(folder / file));
  }
  const Json list = {{"format", "asperity-output"},
                     {"format_version", 1},
                     {"key", keys.output},
                     {"sha256", hashes}};
  const std::string text = text_of_json(list, 2) + "\n";
  write_file_atomically(folder / list_name, text);
  if (!fits)
    return;
  cache.write(keys.output, methods::entry_kind::output, text);
  cache.write(keys.numbers, methods::entry_kind::numbers, text);
  cache.write(keys.numbers, methods::entry_kind::figures, figures);
}

bool has_output(const fs::path& folder, const std::string& key) {
  if (!fs::is_regular_file(folder / list_name))
    return false;
  try {
    const Json list = json_of_text(read_file(folder / list_name, 1 << 26));
    if (list.at("key") != key)
      return false;
    for (const auto& [file, hash] : list.at("sha256").items())
      if (methods::hash_of_file(folder / file) != hash)
        return false;
    return true;
  } catch (const Json::exception&) {
    return false; // edited by hand
  } catch (const FileError&) {
    return false; // a file is missing
  }
}

std::optional<OutputFiles> cached_output(const std::string& key,
                                         methods::Cache& cache) {
  const std::optional<std::string> text =
      cache.read(key, methods::entry_kind::output);
  if (!text)
    return std::nullopt;
  std::optional<OutputFiles> files = listed_files(*text, cache);
  if (files)
    (*files)[list_name] = *text;
  return files;
}

std::optional<KeptNumbers> cached_numbers(const std::string& key,
                                          methods::Cache& cache) {
  const std::optional<std::string> text =
      cache.read(key, methods::entry_kind::numbers);
  std::optional<std::string> figures =
      cache.read(key, methods::entry_kind::figures);
  if (!text || !figures)
    return std::nullopt;
  std::optional<OutputFiles> files = listed_files(*text, cache);
  if (!files)
    return std::nullopt;
  return KeptNumbers{std::move(*files), std::move(*figures)};
}

void write_output(const fs::path& folder, const OutputFiles& files) {
  const auto write = [&](const std::string& file, const std::string& bytes) {
    const fs::path path = folder / file;
    fs::create_directories(path.parent_path());
    const fs::path part = temporary_beside(path);
    // Not synced to disk: output.json, with which the folder is compared,
    // reveals a file that a power failure truncates.
    std::ofstream stream(part, std::ios::binary);
    stream << bytes;
    stream.close();
    if (stream && std::rename(part.c_str(), path.c_str()) == 0)
      return;
    const int error = errno;
    std::error_code ignored;
    fs::remove(part, ignored);
    throw std::system_error(error, std::generic_category(),
                            "cannot write " + path.string());
  };
  // By this file the others are known as ours if not all can be written
  // (run/output_folder.hpp).
  const std::string first = "methods.txt";
  if (const auto mark = files.find(first); mark != files.end())
    write(mark->first, mark->second);
  for (const auto& [file, bytes] : files)
    if (file != first)
      write(file, bytes);
}

} // namespace asperity::run
