#include "run/sweeps/earlier_run.hpp"

#include "cases/reader/case_hash.hpp"
#include "cases/sweeps/sweep.hpp"
#include "input/input_error.hpp"
#include "methods/cache/case_keys.hpp"
#include "methods/chosen.hpp"
#include "results/provenance.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"

namespace asperity::run {

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
  if (!std::filesystem::exists(folder / "result.h5"))
    return {};
  try {
    const results::Result result =
        results::read_result(folder, results::MapsInFile::large);
    results::Inputs inputs = methods::input_hashes(contact_case);
    inputs["program"] = results::build_stamp();
    if (cases::point_content(result.case_text) !=
            cases::point_content(contact_case.text) ||
        results::inputs_of(result) != inputs)
      return {};
    const results::StepsDone done = results::steps_done(result);
    bool has_all = result.status == "complete";
    for (const cases::MethodSpec& method : methods)
      for (const int r : methods::realizations_of(contact_case, method, only)) {
        const auto found = done.find({method.name, r});
        has_all = has_all && found != done.end() &&
                  found->second.size() == contact_case.load.targets.size();
      }
    if (has_all)
      return {RunState::complete, result.case_hash};
    if (result.case_hash == cases::case_hash(contact_case))
      return {RunState::to_resume, result.case_hash};
  } catch (const input::InputError&) { // damaged: it is computed again
  }
  return {};
}

} // namespace asperity::run
