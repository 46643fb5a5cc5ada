#include "tests/run/combination_rows.hpp"

namespace asperity::run::combinations_test {
namespace {

constexpr auto refused = Kind::refused;
constexpr auto omitted = Kind::omitted;
constexpr auto tested = Kind::tested;

const std::string elastic = "penalty|hard|augmented";
const std::string adhesive =
    "exponential|dugdale|cubic|lennard-jones|lennard-jones-10-4|morse";
const std::string of_the_theory = "[magnification]|[adhesion]";

const std::string limit =
    "CombinedStudies.OfEveryLawInItsLimitAreThoseOfHardContact";
const std::string cell = "CombinedStudies.OfAContinuedMapAreThoseOfItsCell";
const std::string turned = "CombinedStudies.OfATurnedMapAreTurned";
const std::string any_method =
    "CombinedStudies.OfTheTheoryDoNotDependOnTheMethods";
const std::string any_path = "CombinedStudies.OfALoadDoNotDependOnThePath";
const std::string reached = "AllMethods.ReachWhatIsAskedFor";
const std::string falling = "CombinedStudies.OfAListThatFallsAreThoseOfACycle";
const std::string contact_sets = "program/contact_sets_test";
const std::string by_pressure =
    "nominal_pressure load|nominal_pressure load-unload";
const std::string by_gap = "mean_gap load|mean_gap load-unload";
const std::string no_spring =
    "needs adhesion in all methods, none of them [md]";
const std::string on_ranks = "program/shared_halfspace_test";

} // namespace

// Without a default: a new law, kind of edges or study does not build until it
// is named here, and its rows below are what the tests then ask for.
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch"

const char* name_in_rows(mechanics::ContactLaw law) {
  using mechanics::ContactLaw;
  switch (law) {
  case ContactLaw::penalty:
    return "penalty";
  case ContactLaw::hard:
    return "hard";
  case ContactLaw::augmented:
    return "augmented";
  case ContactLaw::exponential:
    return "exponential";
  case ContactLaw::dugdale:
    return "dugdale";
  case ContactLaw::cubic:
    return "cubic";
  case ContactLaw::lennard_jones:
    return "lennard-jones";
  case ContactLaw::lennard_jones_layers:
    return "lennard-jones-10-4";
  case ContactLaw::morse:
    return "morse";
  }
  return "";
}

const char* name_in_rows(mechanics::Edges edges) {
  using mechanics::Edges;
  switch (edges) {
  case Edges::periodic:
    return "periodic";
  case Edges::window:
    return "window";
  case Edges::mirror:
    return "mirror";
  case Edges::free:
    return "free";
  }
  return "";
}

#pragma GCC diagnostic pop

std::vector<Row> law_study_rows() {
  return {
      {"*", of_the_theory, tested, any_method},
      {elastic + "|hardness", "[flow]", tested, limit},
      {"exponential|dugdale|cubic", "[flow]", tested, limit},
      {"lennard-jones|lennard-jones-10-4|morse", "[flow]", tested,
       "program/contact_sets_test"},
      {"*", "[spots]|[conductance]", tested, limit},
      {elastic, "normal_stiffness of [conductance]", tested,
       "RoughContact.StiffnessIsTheSlopeOfTheCurve"},
      {"hardness", "normal_stiffness of [conductance]", tested,
       "CombinedStudies.OfAYieldedContactHaveTheStiffnessOfItsUnloading"},
      {adhesive, "normal_stiffness of [conductance]", omitted,
       "needs a contact without adhesion"},
      {"hard", "[friction]", tested, "RoughSlip.IsExactWithoutPoissonsEffect"},
      {"penalty|augmented", "[friction]", tested, limit},
      {adhesive + "|hardness", "[friction]", refused,
       "friction needs a [theory] or a [halfspace] without thickness, adhesion "
       "and hardness"},
      {"*", "stress_inside of [report]", tested, limit},
      {"*", "vtu of [report]", omitted, "needs [fem] with solver = \"full\""},
  };
}

std::vector<Row> edges_study_rows() {
  const std::string continued = "periodic|window|mirror";
  return {
      {"periodic|mirror", "[magnification]", tested, cell},
      {"window", "[magnification]", tested,
       "HannWindow.HasThePowerThatItsCorrectionRestores"},
      {"free", "[magnification]", tested, any_method},
      {"periodic|free", "[adhesion]", tested, any_method},
      {"window|mirror", "[adhesion]", refused,
       "only a measured map is continued in this way"},
      {continued,
       "[flow]|[spots]|[conductance]|normal_stiffness of "
       "[conductance]|[friction]|stress_inside of [report]",
       tested, cell},
      {"free", "[flow]", tested, "program/contact_sets_test"},
      {"free", "[spots]", tested,
       "Clusters.SpanAMapWithFreeBordersFromSideToSide"},
      {"free", "[conductance]", tested,
       "ConductanceTest.OfASphereIsThatOfHolm"},
      {"free", "normal_stiffness of [conductance]", tested,
       "PunchStiffness.OfACircleIsThatOfHolm"},
      {"free", "[friction]", tested, "cases/cattaneo"},
      {"free", "stress_inside of [report]", refused,
       "report.stress_inside computes the stress of a periodic block"},
      {"*", "vtu of [report]", omitted, "needs [fem] with solver = \"full\""},
  };
}

std::vector<Row> method_study_rows() {
  const std::string fem = "fem auto|fem condensed|fem full";
  const std::string fields = "halfspace|winkler|md|" + fem;
  return {
      {"*", of_the_theory, tested, any_method},
      {"halfspace|winkler|" + fem, "[flow]|[spots]|[conductance]", tested,
       turned},
      {"md", "[flow]|[spots]|[conductance]", tested,
       "program/contact_sets_test"},
      {"theory", "[flow]", refused, "flow needs a method with a gap"},
      {"theory", "[spots]", refused, "spots needs a method with a contact map"},
      {"theory", "[conductance]|normal_stiffness of [conductance]", refused,
       "conductance needs a method with a contact map"},
      {"halfspace|fem auto|fem condensed", "normal_stiffness of [conductance]",
       tested, "RoughContact.StiffnessIsTheSlopeOfTheCurve"},
      {"fem full", "normal_stiffness of [conductance]", omitted,
       "needs stiffness = true"},
      {"winkler|md", "normal_stiffness of [conductance]", omitted,
       "needs a [halfspace] or [fem]"},
      {"halfspace", "[friction]", tested,
       "RoughSlip.IsExactWithoutPoissonsEffect"},
      {"theory", "[friction]", tested, "PartialSlip.IsThatOfCattaneo"},
      {"winkler|md|" + fem, "[friction]", refused,
       "friction needs a [theory] or a [halfspace] without thickness, adhesion "
       "and hardness"},
      {"theory|winkler", "stress_inside of [report]", omitted,
       "has no elastic continuum"},
      {"halfspace|md|" + fem, "stress_inside of [report]", tested,
       "StressTables.HaveHertzsMaximumInEachRow"},
      {"fem full", "vtu of [report]", tested, "BlockFiles.AreListedStepByStep"},
      {"halfspace|theory|winkler|md|fem auto|fem condensed", "vtu of [report]",
       omitted, "needs [fem] with solver = \"full\""},
  };
}

std::vector<Row> law_method_rows() {
  const std::string laws = elastic + "|" + adhesive;
  return {
      {laws, "halfspace", tested, contact_sets},
      {elastic, "fem auto|fem condensed", tested, contact_sets},
      {elastic, "fem full", tested, reached},
      {adhesive, "fem auto|fem condensed|fem full", refused,
       "only blocks with element = \"Q1\" and solver = \"condensed\" have "
       "adhesion"},
      {laws, "theory|winkler|md", refused,
       "contact is not a key of this table; it belongs to [halfspace] or "
       "[fem]"},
      {"hardness", "halfspace", tested, reached},
      {"hardness", "theory", tested,
       "CombinedStudies.OfATheoryWithAHardnessEndAtTheLargestLoad"},
      {"hardness", "winkler|md|fem auto|fem condensed|fem full", refused,
       "hardness is not a key of this table; it belongs to [theory] or "
       "[halfspace]"},
  };
}

std::vector<Row> method_edges_rows() {
  const std::string others =
      "theory|winkler|md|fem auto|fem condensed|fem full";
  return {
      {"halfspace", "periodic|free", tested, limit},
      {"halfspace", "window|mirror", tested, cell},
      {others, "*", tested,
       "CombinedStudies.OfEveryMethodOfAContinuedMapAreThoseOfItsCell"},
  };
}

std::vector<Row> method_path_rows() {
  const std::string fields =
      "halfspace|winkler|md|fem auto|fem condensed|fem full";
  return {
      {fields, "nominal_pressure load|mean_gap load", tested, reached},
      {"theory", "nominal_pressure load|mean_gap load", tested,
       "CombinedStudies.OfEveryMethodDoNotDependOnThePath"},
      {"*", "nominal_pressure load-unload|mean_gap load-unload|falling list",
       tested, "CombinedStudies.OfEveryMethodDoNotDependOnThePath"},
      {"*", "spring", refused, no_spring},
  };
}

std::vector<Row> edges_path_rows() {
  return {
      {"free", by_gap, refused, "halfspace has free boundaries"},
      {"free", by_pressure + "|falling list", tested,
       "CombinedStudies.OfEveryEdgesDoNotDependOnThePath"},
      {"periodic|window|mirror", by_pressure + "|falling list|" + by_gap,
       tested, "CombinedStudies.OfEveryEdgesDoNotDependOnThePath"},
      {"*", "spring", refused, no_spring},
  };
}

std::vector<Row> study_path_rows() {
  return {
      {of_the_theory, by_pressure + "|falling list|" + by_gap, tested,
       any_method},
      {"[flow]|[spots]|[conductance]|[friction]|normal_stiffness of "
       "[conductance]|stress_inside of [report]",
       by_pressure + "|" + by_gap, tested, any_path},
      {"[flow]|[spots]|[conductance]|[friction]|normal_stiffness of "
       "[conductance]|stress_inside of [report]",
       "falling list", tested, falling},
      {"vtu of [report]", by_pressure + "|falling list|" + by_gap, omitted,
       "needs [fem] with solver = \"full\""},
      {"*", "spring", refused, no_spring},
  };
}

std::vector<Row> law_path_rows() {
  const std::string up = "nominal_pressure load";
  const std::string back = "nominal_pressure load-unload";
  const std::string gaps = "mean_gap load|mean_gap load-unload";
  return {
      {elastic, up + "|" + back + "|" + gaps, tested, any_path},
      {elastic, "falling list", tested,
       "CombinedStudies.OfAListThatFallsAreThoseOfACycle"},
      {elastic + "|hardness", "spring", refused,
       "needs adhesion in all methods, none of them [md]"},
      {"hardness", up, tested,
       "Hardness.TheStateUnderFirstLoadDoesNotDependOnTheSteps"},
      {"hardness", back, tested,
       "Hardness.UnloadingIsElasticAndReloadingRetracesIt"},
      {"hardness", gaps, tested, "Hardness.IsSolvedAtAMeanGapToo"},
      {"hardness", "falling list", tested,
       "CombinedStudies.OfAYieldedContactHaveTheStiffnessOfItsUnloading"},
      {adhesive, up + "|" + back + "|" + gaps, tested,
       "AdhesiveRoughness.LoadsByGapAndByPressureAgree"},
      {adhesive, "spring", tested, "AdhesiveRoughness.IsHeldByASpring"},
      {adhesive, "falling list", tested,
       "CombinedStudies.OfAListThatFallsAreThoseOfACycle"},
  };
}

std::vector<Row> law_edges_rows() {
  return {
      {"*", "periodic|free", tested, limit},
      {"*", "window|mirror", tested, cell},
  };
}

std::vector<Row> ranks_rows() {
  return {
      {"*",
       "penalty|hard|" + adhesive +
           "|[magnification]|[adhesion]|[flow]|[friction]|[spots]|"
           "[conductance]|normal_stiffness of [conductance]|stress_inside of "
           "[report]|periodic|window|mirror|free|halfspace|theory|winkler|"
           "fem auto|fem condensed|nominal_pressure load",
       tested, on_ranks},
      {"*", "augmented|mean_gap load|mean_gap load-unload", tested, on_ranks},
      {"*", "hardness", tested, on_ranks},
      {"*", "nominal_pressure load-unload|falling list", tested, on_ranks},
      {"*", "fem full", tested, "program/ranks_test"},
      {"*", "md", tested, "program/rank_parts_test"},
      {"*", "spring", refused,
       "needs adhesion in all methods, none of them [md]"},
      {"*", "vtu of [report]", omitted, "needs [fem] with solver = \"full\""},
  };
}

} // namespace asperity::run::combinations_test
