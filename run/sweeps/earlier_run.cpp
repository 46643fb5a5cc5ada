#include "run/sweeps/earlier_run.hpp"

#include "cases/reader/case_hash.hpp"
#include "cases/sweeps/sweep.hpp"
#include "input/input_error.hpp"
#include "methods/cache/case_keys.hpp"
#include "methods/chosen.hpp"
#include "results/provenance.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::run {
namespace {

/// How many load steps a run has to make, and how many of them a result holds.
struct StepCount {
  std::size_t needed = 0;
  std::size_t done = 0;
};

StepCount count_steps(const results::Result& result,
                      const cases::Case& contact_case,
                      const std::vector<cases::MethodSpec>& methods,
                      const std::set<int>& only) {
  const results::StepsDone done = results::steps_done(result);
  StepCount count;
  for (const cases::MethodSpec& method : methods)
    for (const int r : methods::realizations_of(contact_case, method, only)) {
      count.needed += contact_case.load.targets.size();
      if (const auto found = done.find({method.name, r}); found != done.end())
        count.done += found->second.size();
    }
  return count;
}

} // namespace

bool all_converged(const results::Result& result) {
  for (const results::MethodRecord& method : result.methods)
    for (const results::Curve& curve : method.realizations)
      for (const results::CurvePoint& point : curve.points)
        if (point.status == results::StepStatus::not_converged)
          return false;
  return true;
}

EarlierRun earlier_run(const cases::Case& contact_case,
                       const std::vector<cases::MethodSpec>& methods,
                       const std::filesystem::path& folder,
                       const std::set<int>& only) {
  const auto missing = [](const std::string& why) {
    return EarlierRun{.state = RunState::missing, .why = why};
  };
  if (!std::filesystem::exists(folder / "result.h5"))
    return missing("has no result.h5");
  try {
    const results::Result result =
        results::read_result(folder, results::MapsInFile::large);
    results::Inputs inputs = methods::input_hashes(contact_case);
    inputs["program"] = results::build_stamp();
    if (cases::point_content(result.case_text) !=
        cases::point_content(contact_case.text))
      return missing("is of another case");
    if (results::inputs_of(result) != inputs)
      return missing("was computed from other input files or by another build "
                     "of the program");
    const StepCount steps = count_steps(result, contact_case, methods, only);
    if (steps.done == steps.needed && result.status == "complete")
      return {RunState::complete, result.case_hash, "", all_converged(result)};
    if (result.case_hash == cases::case_hash(contact_case))
      return {RunState::to_resume, result.case_hash,
              fmt::format("{}has {} of {} load steps",
                          result.status == "complete"
                              ? ""
                              : "is " + result.status + " and ",
                          steps.done, steps.needed)};
    return missing("is incomplete, and its case is written differently");
  } catch (const input::InputError& error) { // damaged: it is computed again
    return missing(error.what());
  }
}

} // namespace asperity::run
