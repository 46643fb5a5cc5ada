// Tests of joining results: curves, maps, surfaces and facts of all parts, and
// the refusal of a foreign or incomplete part.
#include "base/temporary_folder.hpp"
#include "input/input_error.hpp"
#include "results/joined_result.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "tests/results/sample_result.hpp"

#include <gtest/gtest.h>

#include <map>

namespace asperity::results::joined_result_test {

namespace fs = std::filesystem;

const Grid grid{2, 2, 1e-6, 1e-6};

class JoinedResult : public ::testing::Test {
protected:
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  /// Writes a result with one realisation of one method.
  fs::path part(int realization, const Provenance& facts,
                const CaseInfo& info = case_info,
                const std::string& status = "complete") const {
    const fs::path home = path("part-" + std::to_string(realization));
    ResultWriter writer(home, info);
    SurfaceRecord surface;
    surface.grid = grid;
    surface.heights = {1e-9 * realization, 0.0, 0.0, 0.0};
    fill_numbers(surface);
    writer.record_surface(realization, surface);
    writer.begin_method("fem", "fem", "a block");
    writer.record_own_surface("fem", realization, surface);
    writer.record_setup_time("fem", realization, 0.5 + realization);
    CurvePoint row;
    row.nominal_pressure = 1e6;
    row.mean_gap = 1e-9 * (realization + 1);
    row.contact_stiffness = 1e15;
    writer.append_step_with_fields(
        "fem", realization, row, grid,
        {0, 1e6, {1.0, 2.0, 3.0, 4.0}, {0, 0, 0, 0}});
    if (realization == 0)
      writer.record_table({"leak", "a table", {{"x", "m", {1.0, 2.0}}}});
    writer.record_provenance(facts);
    writer.record_skipped(std::vector<Skipped>{{"maps", "not asked for"}});
    writer.finish(status);
    return home;
  }

  static const CaseInfo case_info;

private:
  TemporaryFolder folder_{"asperity"};
};

const CaseInfo JoinedResult::case_info{
    "rough",
    "a title",
    "schema = 1",
    "abc",
    1e9,
    "a reference",
    {{"program", "stamp"}, {"surface.file", "hash"}}};

TEST_F(JoinedResult, HoldsEveryRealisation) {
  const fs::path second = part(1, {});
  const fs::path third = part(2, {});

  join_results({part(0, {}), third, second}, path("whole"));

  const Result whole = read_result(path("whole"));
  EXPECT_EQ(whole.status, "complete");
  EXPECT_EQ(whole.case_text, "schema = 1");
  EXPECT_EQ(whole.reference, "a reference");
  EXPECT_EQ(inputs_of(whole), case_info.inputs);
  ASSERT_EQ(whole.surfaces.size(), 3U);
  ASSERT_EQ(whole.methods.size(), 1U);
  ASSERT_EQ(whole.methods[0].realizations.size(), 3U);
  for (std::size_t r = 0; r < 3; ++r) {
    const Curve& curve = whole.methods[0].realizations[r];
    EXPECT_EQ(whole.surfaces[r].heights[0], 1e-9 * static_cast<double>(r));
    EXPECT_EQ(curve.own_surface->heights, whole.surfaces[r].heights);
    EXPECT_EQ(curve.setup_cpu_time, 0.5 + static_cast<double>(r));
    EXPECT_EQ(curve.points.at(0).mean_gap, 1e-9 * static_cast<double>(r + 1));
    EXPECT_EQ(curve.fields.at(0).pressure,
              (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
  }
  ASSERT_NE(whole.table("leak"), nullptr);
  EXPECT_EQ(whole.table("leak")->values("x"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(whole.skipped.size(), 1U);
}

// Maps that a reader leaves in the file of a part are copied from there.
TEST_F(JoinedResult, HoldsTheLargeMapsOfEveryRealisation) {
  constexpr Grid large{1200, 900, 1e-6, 1e-6};
  ASSERT_GT(large.size(), large_map);
  SurfaceRecord surface;
  surface.grid = large;
  Fields fields{3, 1e6, {}, {}, large};
  for (std::size_t i = 0; i < large.size(); ++i) {
    surface.heights.push_back(1e-9 * static_cast<double>(i % 1009));
    fields.pressure.push_back(static_cast<double>(i % 97));
    fields.gap.push_back(static_cast<double>(i % 89));
  }
  fill_numbers(surface);
  CurvePoint row;
  row.step = 3;
  row.nominal_pressure = 1e6;
  for (const int realization : {0, 1}) {
    ResultWriter writer(part(realization, {}), case_info,
                        ResultWriter::Mode::resume);
    writer.record_surface(realization, surface);
    writer.record_own_surface("fem", realization, surface);
    writer.append_step_with_fields("fem", realization, row, large, fields);
    writer.finish("complete");
  }

  join_results({path("part-0"), path("part-1")}, path("whole"));

  const Result whole = read_result(path("whole"));
  for (const std::size_t r : {0, 1}) {
    const Curve& curve = whole.methods.at(0).realizations.at(r);
    EXPECT_TRUE(whole.surfaces.at(r).heights == surface.heights);
    EXPECT_TRUE(curve.own_surface->heights == surface.heights);
    ASSERT_EQ(curve.fields.size(), 2U);
    EXPECT_EQ(curve.fields[0].pressure.size(), grid.size());
    EXPECT_EQ(curve.fields[1].step, 3);
    EXPECT_EQ(curve.fields[1].grid, large);
    EXPECT_TRUE(curve.fields[1].pressure == fields.pressure);
    EXPECT_TRUE(curve.fields[1].gap == fields.gap);
  }
}

TEST_F(JoinedResult, JoinsTheFacts) {
  const Provenance one{{"started", "2026-01-02T00:00:00Z"},
                       {"finished", "2026-01-02T01:00:00Z"},
                       {"wall time", "9.50 s"},
                       {"CPU time", "1.25 s"},
                       {"peak memory", "100 MiB"},
                       {"steps computed", "7"},
                       {"processor", "A"},
                       {"seed", "3"}};
  const Provenance two{{"started", "2026-01-01T00:00:00Z"},
                       {"finished", "2026-01-03T00:00:00Z"},
                       {"wall time", "10.00 s"},
                       {"CPU time", "2.50 s"},
                       {"peak memory", "20 MiB"},
                       {"steps computed", "8"},
                       {"processor", "B"},
                       {"seed", "3"},
                       {"deal.II", "9"}};
  Provenance three = two;
  three.erase(three.begin(), three.begin() + 6); // a machine like the second

  join_results({part(0, one), part(1, two), part(2, three)}, path("whole"));

  const Provenance read = read_result(path("whole")).provenance;
  const std::map<std::string, std::string> facts(read.begin(), read.end());
  const std::map<std::string, std::string> expected{
      {"started", "2026-01-01T00:00:00Z"},
      {"finished", "2026-01-03T00:00:00Z"},
      {"wall time", "10.00 s"},
      {"CPU time", "3.75 s"},
      {"peak memory", "100 MiB"},
      {"steps computed", "15"},
      {"processor", "A; B"},
      {"seed", "3"},
      {"deal.II", "9"},
      {"parts", "3"},
      {"input program", "stamp"},
      {"input surface.file", "hash"}};
  EXPECT_EQ(facts, expected);
}

TEST_F(JoinedResult, RefusesPartsThatDoNotBelongTogether) {
  const fs::path first = part(0, {});
  CaseInfo other = case_info;
  other.hash = "def";
  EXPECT_THROW(join_results({first, part(1, {}, other)}, path("whole")),
               input::InputError);
  other = case_info;
  other.inputs["program"] = "another";
  EXPECT_THROW(join_results({first, part(1, {}, other)}, path("whole")),
               input::InputError);
  EXPECT_THROW(join_results({first, part(1, {}, case_info, "interrupted")},
                            path("whole")),
               input::InputError);
  EXPECT_THROW(join_results({first, first}, path("whole")), std::domain_error);
  EXPECT_THROW(join_results({}, path("whole")), std::domain_error);
}

} // namespace asperity::results::joined_result_test
