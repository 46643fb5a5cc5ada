// Tests of input/types/omissions.hpp: what a case asks of its methods, and
// which of them say that they have no answer.
#include "input/types/omissions.hpp"
#include "tests/cases/case_samples.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace asperity::cases::omissions_test {

using Said = std::map<std::string, std::string>; ///< method -> sentences

Case read(std::vector<std::string> overrides) {
  overrides.emplace_back("expect=");
  return read_case_text(contact_case, "case.toml", overrides);
}

Said said(const Case& contact_case) {
  Said all;
  for (const MethodSpec& method : contact_case.methods)
    for (const Omission& one : omissions(contact_case, method))
      all[method.name] +=
          (all[method.name].empty() ? "" : "; ") + one.sentence();
  return all;
}

std::vector<std::string> warned(const Case& contact_case) {
  return omission_warnings(contact_case, contact_case.methods);
}

TEST(Omissions, AreNoneOfACaseThatAsksNothing) {
  EXPECT_TRUE(said(read({})).empty());
  EXPECT_TRUE(warned(read({})).empty());
}

TEST(Omissions, OfASlipThatTheTheoryAloneHas) {
  const Case slip =
      read({"friction.coefficient=0.3", "halfspace.contact=exponential",
            "halfspace.work_of_adhesion=50 mJ/m^2"});

  EXPECT_EQ(said(slip),
            (Said{{"halfspace", "[friction] is not computed: needs a contact "
                                "without adhesion"},
                  {"fem", "[friction] is not computed: needs a [halfspace] or "
                          "a [theory]"}}));
  EXPECT_EQ(warned(slip),
            std::vector<std::string>{
                "[friction] is computed by the theory alone: halfspace needs a "
                "contact without adhesion, fem needs a [halfspace] or a "
                "[theory]"});
  // Not where a method with fields has an answer, too.
  EXPECT_TRUE(warned(read({"friction.coefficient=0.3"})).empty());
}

TEST(Omissions, OfAMaterialThatNoMethodHas) {
  const Case hollow = read({"fem=", "theory=",
                            "material.inclusion={ radius = "
                            "1e-6, depth = 3e-6, "
                            "youngs_modulus = 1e9, "
                            "poisson_ratio = 0.3 }"});
  const std::string why = "has a laterally uniform material";

  EXPECT_EQ(said(hollow), (Said{{"halfspace", "[material.inclusion] is not "
                                              "computed: " +
                                                  why}}));
  EXPECT_EQ(warned(hollow),
            std::vector<std::string>{"[material.inclusion] is computed by none "
                                     "of the methods of this run: halfspace " +
                                     why});
  const Case coated = read({"material.layers=[{ thickness = 1e-7, "
                            "youngs_modulus = 1e9, poisson_ratio = 0.3 }]"});
  EXPECT_EQ(said(coated), (Said{{"theory", "[[material.layers]] is not "
                                           "computed: has a uniform "
                                           "material"}}));
  EXPECT_TRUE(warned(coated).empty());
}

TEST(Omissions, OfTablesWithoutTheirTheory) {
  const Case magnified =
      read({"magnification={ nominal_pressure = 1e6, from = 1.0, to = 4.0, "
            "points = 3 }"});
  const std::vector<MethodSpec> without(magnified.methods.begin() + 1,
                                        magnified.methods.end());

  EXPECT_TRUE(warned(magnified).empty());
  EXPECT_EQ(omission_warnings(magnified, without),
            std::vector<std::string>{"[magnification] is computed by none of "
                                     "the methods of this run"});
}

// Each question is in the list once.
TEST(Omissions, HaveOneRowForEachQuestion) {
  std::set<std::string> names;
  for (const AskedTraits& one : all_asked())
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
  EXPECT_TRUE(names.contains("[flow]"));
}

} // namespace asperity::cases::omissions_test
