// Verifies that the reader accepts any value of a key or refuses it by an
// input::InputError that names a place, and that it never throws anything else.
#include "input/reader/vocabulary.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace asperity::cases::any_text_test {

std::vector<std::string> all_paths() {
  std::vector<std::string> paths = {"load.nominal_pressure.from",
                                    "load.nominal_pressure.to",
                                    "load.nominal_pressure.steps",
                                    "load.nominal_pressure.spacing",
                                    "fem.hard",
                                    "fem.hard.contact",
                                    "expect.gamma_slope.within",
                                    "expect.gamma_slope.methods"};
  for (const Table& table : vocabulary()) {
    if (table.is_part)
      continue;
    paths.push_back(table.name);
    for (const Key& key : table.keys)
      paths.push_back(table.name.empty() ? key.name
                                         : table.name + "." + key.name);
  }
  return paths;
}

std::vector<std::string> awkward_values() {
  std::vector<std::string> values = {"",
                                     "0",
                                     "-1",
                                     "7",
                                     "1e300",
                                     "nan",
                                     "-inf",
                                     "1e-300",
                                     "true",
                                     "[]",
                                     "[1, 2]",
                                     "[[]]",
                                     "{}",
                                     "{ a = 1 }",
                                     "\"\"",
                                     "3 nm",
                                     "3 E*",
                                     "2 h",
                                     "2 h_rms",
                                     "1 length",
                                     "100 E*/h",
                                     "9223372036854775806",
                                     "2147483648",
                                     "1979-05-27",
                                     "hard",
                                     "{ from = 1 }",
                                     "{ value = 1, within = \"5 %\" }",
                                     "{ below = -1 }",
                                     "5 %",
                                     "[\"fem\"]"};
  for (const Table& table : vocabulary())
    for (const Key& key : table.keys)
      for (const std::string& word : key.words)
        values.push_back(word);
  return values;
}

RC_GTEST_PROP(AnyText, IsReadOrRefusedWithAPlace, ()) {
  static const std::vector<std::string> paths = all_paths();
  static const std::vector<std::string> values = awkward_values();
  std::vector<std::string> overrides;
  const int count = *rc::gen::inRange(1, 6);
  for (int i = 0; i < count; ++i)
    overrides.push_back(*rc::gen::elementOf(paths) + "=" +
                        *rc::gen::elementOf(values));

  try {
    const Case read = read_case_text(contact_case, "case.toml", overrides);
    RC_ASSERT(!read.methods.empty());
    RC_ASSERT(read.load.targets.size() == read.load.is_unloading.size());
    RC_ASSERT(!read.load.targets.empty());
    RC_ASSERT(read.material.contact_modulus > 0.0);
  } catch (const input::InputError& error) {
    const std::string message = error.what();
    RC_ASSERT(message.find(" mistake(s) in the case file\n  ") !=
              std::string::npos);
  }
}

// Text that is not a case at all is refused as such.
RC_GTEST_PROP(AnyText, OfLettersAndSignsIsNoCase, ()) {
  const auto text = *rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("a1.=[]{}\"'# \n,-+_e\\")));

  RC_ASSERT_THROWS_AS(read_case_text(text, "case.toml"), input::InputError);
}

} // namespace asperity::cases::any_text_test
