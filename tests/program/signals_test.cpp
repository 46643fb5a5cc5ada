// What a signal does to a run that has loaded deal.II, whose libraries set
// signals themselves.
#include "tests/program/program.hpp"

namespace asperity::program::signals_test {

const std::string rough_map = R"(schema = 1
title = "Signals"
[surface]
kind = "self-affine"
length = "10 um"
points = 128
seed = 3
rms_slope = 0.1
hurst = 0.8
wavelength_long = "1 length"
wavelength_roll_off = "0.25 length"
wavelength_short = "8 h"
[material]
contact_modulus = "2 GPa"
[load]
nominal_pressure = { from = "2e-3 E*", to = "1e-2 E*", steps = 400, spacing = "linear" }
[halfspace]
contact = "hard"
[flow]
viscosity = "1 mPa s"
pressure_drop = "10 kPa"
)";

class Signals : public ProgramTest {
protected:
  /// Runs a case as by nohup. After its first step it gets SIGHUP, as from a
  /// terminal that is closed, and SIGTERM, as from a scheduler.
  Ended hang_up_and_terminate(const std::string& contact_case) const {
    write("case.toml", contact_case);
    write("signals.sh",
          "trap '' HUP\n"
          "\"$@\" &\n"
          "until ls cache/*.step > ls.txt 2>&1 || ! kill -0 $! 2>&-; "
          "do sleep 0.01; done\n"
          "kill -HUP $! && kill -TERM $!\n"
          "wait $!\n");
    return run("run case.toml --out one", "sh signals.sh");
  }

  void expect_report_of_an_interrupted_run(const Ended& ended) const {
    EXPECT_EQ(ended.exit_code, 130) << ended.output;
    EXPECT_NE(ended.output.find("interrupted; continue with --resume"),
              std::string::npos)
        << ended.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "one/report.html"));
  }
};

TEST_F(Signals, EndAFlowInAnOrderlyWay) {
  expect_report_of_an_interrupted_run(hang_up_and_terminate(rough_map));
}

TEST_F(Signals, EndAPlasticBlockInAnOrderlyWay) {
  expect_report_of_an_interrupted_run(hang_up_and_terminate(imprint_case(400)));
}

} // namespace asperity::program::signals_test
