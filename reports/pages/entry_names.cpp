#include "reports/pages/entry_names.hpp"

#include "input/reader/resolved_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace asperity::reports {
namespace {

using KeyTexts = std::map<std::string, std::string>;

constexpr std::size_t most_keys = 3; // in a name

/// The keys of a case as they are written, and the defaults.
KeyTexts key_texts(const ReportEntry& entry) {
  KeyTexts texts;
  if (!entry.result->case_text.empty())
    for (const cases::ResolvedKey& key :
         cases::resolved_keys(*entry.contact_case, {}))
      if (key.path != "title" && !key.path.starts_with("expect."))
        texts[key.path] = key.written.empty() ? "default" : key.written;
  return texts;
}

/// The keys whose values are not the same in all.
std::set<std::string> differing_keys(const std::vector<KeyTexts>& all) {
  std::set<std::string> keys;
  for (const KeyTexts& one : all)
    for (const auto& [key, value] : one)
      for (const KeyTexts& other : all)
        if (const auto found = other.find(key);
            found == other.end() || found->second != value)
          keys.insert(key);
  return keys;
}

std::string name_by_keys(const KeyTexts& texts,
                         const std::set<std::string>& keys) {
  std::string words;
  std::size_t named = 0;
  for (const std::string& key : keys) {
    const auto found = texts.find(key);
    if (named++ == most_keys)
      return words + ", ...";
    words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", key,
                         found == texts.end() ? "none" : found->second);
  }
  return words;
}

std::string folder_of_result(const ReportEntry& entry) {
  const std::filesystem::path path =
      std::filesystem::path(entry.result->path).lexically_normal();
  return path.extension() == ".h5" || !path.has_filename()
             ? path.parent_path().string()
             : path.string();
}

/// Appends what tells the results of one name apart.
void tell_apart(const std::vector<ReportEntry*>& same) {
  std::vector<KeyTexts> texts;
  std::set<std::string> folders;
  for (const ReportEntry* entry : same) {
    texts.push_back(key_texts(*entry));
    folders.insert(folder_of_result(*entry));
  }
  const std::set<std::string> keys = differing_keys(texts);
  const std::set<KeyTexts> different(texts.begin(), texts.end());
  for (std::size_t i = 0; i < same.size(); ++i) {
    const std::string words =
        different.size() == same.size() ? name_by_keys(texts[i], keys)
        : folders.size() == same.size() ? folder_of_result(*same[i])
                                        : fmt::format("result {}", i + 1);
    same[i]->summary.case_name += " (" + words + ")";
  }
}

} // namespace

void name_entries(std::span<ReportEntry> entries,
                  std::span<const std::string> labels) {
  std::map<std::string, std::vector<ReportEntry*>> named;
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (i < labels.size() && !labels[i].empty())
      entries[i].summary.case_name = labels[i];
    else
      named[entries[i].summary.case_name].push_back(&entries[i]);
  for (const auto& [name, same] : named)
    if (same.size() > 1)
      tell_apart(same);
}

} // namespace asperity::reports
