// Combinations have an owner. Each pair of two of law, method, edges, study,
// path and ranks has one row, with the refusal of the reader, what the method
// says that it leaves out, or the name of a test of a property of the pair: a
// limit, a symmetry or a second way to the number. The values come from the
// registries of the program: a new law, study, kind of edges, method or path
// fails here until its rows are there, and the failure says what the program
// does with the pair.
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "input/reader/study_keys.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/types/omissions.hpp"
#include "run/plan/plan.hpp"
#include "tests/folder.hpp"
#include "tests/run/combination_rows.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace asperity::run::combinations_test {

using Entries = std::vector<std::string>;
using Names = std::vector<std::string>;

constexpr const char* pressed_map = R"(schema = 1
[surface]
kind = "measured"
file = "map.txt"
length = "1 um"
height_unit = "1 nm"
level = "none"
edges = "periodic"
[material]
youngs_modulus = "2 GPa"
poisson_ratio = 0.3
[load]
nominal_pressure = ["1 MPa", "4 MPa", "10 MPa"]
[halfspace]
)";

const cases::Key& key_of(const char* table, const char* name) {
  return cases::vocabulary_key(cases::vocabulary_table(table), name);
}

Names words_of(const char* table, const char* name) {
  return key_of(table, name).words;
}

// The registries.

/// The laws of contact, and the one that hard contact may have besides.
Names laws() {
  Names names{"hardness"};
  for (const mechanics::ContactLawTraits& law : mechanics::contact_laws())
    names.emplace_back(law.name);
  return names;
}

/// The tables of studies, and what else a case asks of its methods.
Names studies() {
  Names names;
  for (const cases::StudyKeys* const study : cases::known_studies())
    if (!study->tables.empty())
      names.push_back("[" + study->name() + "]");
  for (const cases::AskedTraits& one : cases::all_asked())
    if (std::string(one.name).find("[material") == std::string::npos &&
        std::ranges::find(names, one.name) == names.end())
      names.emplace_back(one.name);
  return names;
}

Names edges() {
  return words_of("surface", "edges");
}

/// The tables of methods, and the solvers of [fem].
Names methods() {
  Names names;
  for (const cases::Table& table : cases::vocabulary())
    if (table.is_method && table.name != "fem")
      names.push_back(table.name);
  for (const std::string& solver : words_of("fem", "solver"))
    names.push_back("fem " + solver);
  return names;
}

/// What is prescribed, in which cycle, by which spring.
Names paths() {
  Names names;
  for (const cases::Key& key : cases::vocabulary_table("load").keys) {
    if (key.type == cases::ValueType::program)
      for (const std::string& cycle : words_of("load", "cycle"))
        names.push_back(key.name + " " + cycle);
    else if (key.name != "cycle")
      names.push_back(key.name);
  }
  names.emplace_back("falling list");
  return names;
}

Names ranks() {
  return {"one rank", "several ranks"};
}

// What a case has to say to have a value of a registry.

const std::map<std::string, Entries>& entries_of_values() {
  static const Entries work{"halfspace.work_of_adhesion=1 mJ/m^2"};
  static const std::map<std::string, Entries> entries = [] {
    std::map<std::string, Entries> all{
        {"hardness", {"halfspace.hardness=50 MPa"}},
        {"[magnification]",
         {"theory.gamma=0.4", "magnification={ nominal_pressure = 1e6, from = "
                              "1.0, to = 10.0, points = 3, "
                              "reference_wavelength = 1e-6 }"}},
        {"[adhesion]",
         {"surface={ kind = \"self-affine\", length = 1e-6, points = 16, seed "
          "= 1, rms_slope = 0.1, hurst = 0.8, wavelength_long = 1e-6, "
          "wavelength_roll_off = 1e-6, wavelength_short = 2.5e-7 }",
          "theory.gamma=0.4",
          "adhesion={ work_of_adhesion = 0.1, from = 0.5, "
          "to = 1.5, points = 3 }"}},
        {"[flow]", {"flow={ viscosity = 1e-3, pressure_drop = 1e5 }"}},
        {"[friction]", {"friction.coefficient=0.3"}},
        {"[spots]", {"spots={}"}},
        {"[conductance]", {"conductance={}"}},
        {"normal_stiffness of [conductance]", {"conductance={}"}},
        {"stress_inside of [report]", {"report.stress_inside=true"}},
        {"vtu of [report]", {"report.vtu=true"}},
        {"halfspace", {}},
        {"theory", {"theory.gamma=0.4", "halfspace="}},
        {"winkler", {"winkler.stiffness=0.1 E*/h", "halfspace="}},
        {"md",
         {"md.interaction_energy=74.4 meV",
          "md.interaction_distance=3.28 angstrom", "md.cutoff=10 angstrom",
          "md.contact_distance=4.3615 angstrom", "halfspace="}},
        {"nominal_pressure load", {}},
        {"nominal_pressure load-unload", {"load.cycle=load-unload"}},
        {"mean_gap load", {"load={ mean_gap = [2e-9, 1e-9] }"}},
        {"mean_gap load-unload",
         {"load={ mean_gap = [2e-9, 1e-9], cycle = \"load-unload\" }"}},
        {"spring", {"load={ mean_gap = [2e-9, 1e-9], spring = \"0.1 E*/h\" }"}},
        {"falling list", {"load.nominal_pressure=[4e6, 1e7, 4e6]"}},
        {"one rank", {}},
        {"several ranks", {}},
    };
    for (const mechanics::ContactLawTraits& law : mechanics::contact_laws()) {
      Entries& own = all[law.name];
      own.push_back(std::string("halfspace.contact=") + law.name);
      if (law.needs_penalty)
        own.emplace_back("halfspace.penalty=100 E*/h");
      if (mechanics::is_adhesive(law.law))
        own.insert(own.end(), work.begin(), work.end());
    }
    for (const std::string& word : edges())
      all[word] = {"surface.edges=" + word};
    all["window"].emplace_back("surface.press_windowed_map=true");
    for (const std::string& solver : words_of("fem", "solver"))
      all["fem " + solver] = {"fem.solver=" + solver, "fem.growth=2.0",
                              "halfspace="};
    return all;
  }();
  return entries;
}

/// The table of the one of two values that is a method, else that of the
/// half-space.
std::string method_table(const std::string& first, const std::string& second) {
  for (const std::string& name : methods())
    if (name == first || name == second)
      return name.substr(0, name.find(' '));
  return "halfspace";
}

/// Whether a value is among "a|b|c"; "*" stands for all.
bool names(const std::string& list, const std::string& value) {
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, '|');)
    if (part == "*" || part == value)
      return true;
  return false;
}

/// All tests of the tree: "Suite.Name" of those in C++, "folder/name" of those
/// in Python, and "cases/name" of the shipped cases with their expectations.
std::set<std::string> tests_of_the_tree() {
  std::set<std::string> found;
  const std::regex macro(
      R"((?:TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\((\w+),\s*(\w+))");
  for (const auto& file :
       std::filesystem::recursive_directory_iterator(ASPERITY_TESTS)) {
    const std::filesystem::path& path = file.path();
    if (path.extension() == ".py")
      found.insert(path.parent_path().filename().string() + "/" +
                   path.stem().string());
    if (path.extension() != ".cpp")
      continue;
    std::ifstream stream(path);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    for (std::sregex_iterator at(text.begin(), text.end(), macro), end;
         at != end; ++at)
      found.insert((*at)[1].str() + "." + (*at)[2].str());
  }
  for (const auto& folder : std::filesystem::directory_iterator(ASPERITY_CASES))
    found.insert("cases/" + folder.path().filename().string());
  return found;
}

/// What the program does with a pair.
struct Answer {
  Kind kind = Kind::tested;
  std::string text; ///< the refusal, or what the method leaves out
};

const char* word_of(Kind kind) {
  return kind == Kind::refused   ? "refused"
         : kind == Kind::omitted ? "omitted"
                                 : "allowed";
}

class Combinations : public tests::FolderTest {
protected:
  Combinations() {
    std::ofstream map(folder / "map.txt");
    for (int row = 0; row < 16; ++row)
      for (int column = 0; column < 16; ++column)
        map << (row * 7 + column * column) % 11 << (column == 15 ? "\n" : " ");
  }

  Answer answer(const std::string& first, const std::string& second) const {
    Entries entries = entries_of_values().at(first);
    const Entries& others = entries_of_values().at(second);
    entries.insert(entries.end(), others.begin(), others.end());
    // A surface comes before its edges.
    std::ranges::stable_partition(entries, [](const std::string& entry) {
      return entry.starts_with("surface={");
    });
    // The law is that of the method that has replaced the half-space.
    const std::string table = method_table(first, second);
    for (std::string& entry : entries)
      if (entry.starts_with("halfspace."))
        entry = table + entry.substr(entry.find('.'));
    try {
      const cases::Case read = cases::read_case_text(
          pressed_map, (folder / "case.toml").string(), entries);
      make_plan(read, {folder / "out", {}, false, 1});
      auto method =
          std::ranges::find_if(read.methods, &cases::MethodSpec::has_fields);
      if (method == read.methods.end())
        method = read.methods.begin();
      for (const cases::Omission& one : cases::omissions(read, *method))
        if (one.what == first || one.what == second)
          return {Kind::omitted, one.why};
      return {};
    } catch (const input::InputError& error) {
      return {Kind::refused, error.what()};
    } catch (const std::domain_error& error) {
      return {Kind::refused, error.what()};
    }
  }

  void check(const std::string& first, const std::string& second,
             const std::vector<Row>& rows) const {
    SCOPED_TRACE(first + " x " + second);
    const Answer found = answer(first, second);
    std::vector<Row> own;
    for (const Row& row : rows)
      if (names(row.first, first) && names(row.second, second))
        own.push_back(row);
    ASSERT_EQ(own.size(), 1U) << "rows of this pair, which is "
                              << word_of(found.kind) << ": " << found.text;
    const Row& row = own.front();
    ASSERT_EQ(word_of(found.kind), std::string(word_of(row.kind)))
        << found.text;
    if (row.kind == Kind::tested)
      EXPECT_TRUE(known_tests().contains(row.text))
          << "there is no test " << row.text;
    else
      EXPECT_NE(found.text.find(row.text), std::string::npos) << found.text;
  }

  void check(const Names& firsts, const Names& seconds,
             const std::vector<Row>& rows) const {
    for (const std::string& first : firsts)
      for (const std::string& second : seconds)
        check(first, second, rows);
  }

  static const std::set<std::string>& known_tests() {
    static const std::set<std::string> all = tests_of_the_tree();
    return all;
  }
};

// The switches of name_in_rows() are complete when the test is built.
TEST_F(Combinations, HaveTheNamesOfTheProgram) {
  for (const mechanics::ContactLawTraits& law : mechanics::contact_laws())
    EXPECT_EQ(law.name, std::string(name_in_rows(law.law)));
  const Names words = edges();
  for (std::size_t i = 0; i < words.size(); ++i)
    EXPECT_EQ(words[i], name_in_rows(static_cast<mechanics::Edges>(i)));
}

TEST_F(Combinations, OfLawsAndStudies) {
  check(laws(), studies(), law_study_rows());
}

TEST_F(Combinations, OfEdgesAndStudies) {
  check(edges(), studies(), edges_study_rows());
}

TEST_F(Combinations, OfMethodsAndStudies) {
  check(methods(), studies(), method_study_rows());
}

TEST_F(Combinations, OfLawsAndMethods) {
  check(laws(), methods(), law_method_rows());
}

TEST_F(Combinations, OfMethodsAndEdges) {
  check(methods(), edges(), method_edges_rows());
}

TEST_F(Combinations, OfMethodsAndPaths) {
  check(methods(), paths(), method_path_rows());
}

TEST_F(Combinations, OfEdgesAndPaths) {
  check(edges(), paths(), edges_path_rows());
}

TEST_F(Combinations, OfStudiesAndPaths) {
  check(studies(), paths(), study_path_rows());
}

TEST_F(Combinations, OfLawsAndPaths) {
  check(laws(), paths(), law_path_rows());
}

TEST_F(Combinations, OfLawsAndEdges) {
  check(laws(), edges(), law_edges_rows());
}

TEST_F(Combinations, OfRanksAndTheRest) {
  for (const Names& rest : {laws(), studies(), edges(), methods(), paths()})
    check(ranks(), rest, ranks_rows());
}

} // namespace asperity::run::combinations_test
