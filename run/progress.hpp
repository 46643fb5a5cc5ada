#pragma once

// Shows the progress of a run: a bar on a terminal, one line per step in a
// pipe, and the remaining time, estimated from the steps that are done. While a
// long step is at work, it is shown that it is, and for how long. The class
// owns the clock of the run.

#include "results/types/result.hpp"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace asperity::run {

/// Formats a time for the reader: "8.2 s", "4 min", "2.5 h".
std::string time_text(double seconds);

/// Formats what is left: "about 4 min left", or "time left unknown".
std::string remaining_text(const std::optional<double>& seconds);

/// The same of equal pieces of work since `begin`; "" within the first ten
/// seconds and at the end.
std::string remaining_text(std::chrono::steady_clock::time_point begin,
                           std::size_t done, std::size_t all);

/// Returns the part of an iteration that is done, 0 to 1: the orders of
/// magnitude by which its residual, which was about 1, has fallen, over those
/// of the tolerance. It is 0 if the residual is not known.
double share_done(double residual, double tolerance);

/// The unfinished step of a run that takes longest.
struct StepAtWork {
  std::string method = {};
  double elapsed = 0.0; ///< wall time since it began [s]
  double share = 0.0;   ///< part that is done, 0 to 1; 0: not known
};

/// Estimates how long a run still takes: a step costs the mean CPU time of the
/// steps of its method that are done, or, if there are none, that of the
/// dearest method.
class RemainingWork {
public:
  /// @param steps  to be done, by method
  explicit RemainingWork(const std::map<std::string, int>& steps);

  /// Counts a step that was computed.
  void add_done(const std::string& method, double cpu_time);

  /// Counts steps that need not be computed.
  void add_kept(const std::string& method, int n_steps);

  int steps() const { return n_steps_; }

  int steps_done() const { return n_done_; }

  /// Returns the estimated remaining wall time [s]; empty where no step is
  /// done and the share of the step at work is not known, or where that takes
  /// longer than estimated. A known share that promises a longer time than the
  /// finished steps replaces their estimate.
  ///
  /// @param elapsed     wall time since the beginning [s]
  /// @param since_last  of this, since the last finished step [s]
  std::optional<double> seconds_left(double elapsed, double since_last,
                                     const StepAtWork& step = {}) const;

private:
  struct MethodWork {
    int left = 0;
    int done = 0;
    double cpu_time = 0.0; ///< of those that are done [s]
  };

  double mean_cost(const MethodWork& work) const;

  std::map<std::string, MethodWork> methods_;
  int n_steps_ = 0;
  int n_done_ = 0;
};

/// Returns a line with a bar, the counters and some words, cut off so that it
/// is shorter than a line of the terminal. The bar is shorter below 100
/// columns.
std::string bar_line(int done, int steps, const std::string& words,
                     int columns);

/// Shows the progress. The class is thread-safe.
class Progress {
public:
  /// @param work             the steps to do
  /// @param contact_modulus  E* [Pa], unit of the displayed pressures
  /// @param silence          longest time without a line in a pipe
  Progress(RemainingWork work, double contact_modulus,
           std::chrono::milliseconds silence = std::chrono::seconds(20));

  ~Progress(); ///< calls end()

  /// Removes the bar, so that other text can be printed. Nothing may be
  /// reported after it.
  void end();

  /// Something that takes time, from its construction to its end.
  class Activity {
  public:
    /// @param what  for the reader: "fem, realization 0, step 3"
    Activity(Progress& progress, const std::string& what);
    ~Activity();

    Activity(const Activity&) = delete;
    Activity& operator=(const Activity&) = delete;

  private:
    Progress& progress_;
    int id_;
  };

  /// @param rms_height  h_rms [m], unit of the displayed gaps
  void step_done(const std::string& method, int realization,
                 const results::CurvePoint& point, double rms_height);

  /// Reports steps that an earlier run computed.
  void steps_kept(const std::string& method, int realization, int n_steps);

  /// Returns what the text of an activity of a method begins with.
  static std::string job_text(const std::string& method, int realization);

  /// Reports the state of an unfinished step, of which an Activity exists. It
  /// is shown a few times per second on a terminal, and in a pipe with the next
  /// line on the activity.
  /// @param words  "Newton step 3, residual 1e-3"
  /// @param share  part of the step that is done, 0 to 1; 0: not known
  void at_work(const std::string& method, int realization,
               const std::string& words, double share = 0.0);

private:
  using Clock = std::chrono::steady_clock;

  struct Running {
    std::string what;
    Clock::time_point since;
    std::string method = {};
    std::string brief = {}; ///< "fem r0"
    std::string words = {}; ///< of at_work(); may be empty
    double share = 0.0;     ///< of at_work()
  };

  /// Shows unfinished work until the destructor ends it.
  void watch();
  /// Returns the activity that takes longest; null if there is none.
  const Running* longest_activity() const;
  /// Returns the words on an activity behind the bar of a terminal.
  std::string brief_text(const Running& running, Clock::time_point now) const;
  std::string remaining(Clock::time_point now) const;
  /// Draws the bar over the last one, without a line break.
  void draw_bar(const std::string& words) const;

  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_ended_ = false;
  RemainingWork work_;
  double contact_modulus_;
  bool is_terminal_;
  std::chrono::milliseconds silence_;
  Clock::time_point start_;
  Clock::time_point last_done_;
  Clock::time_point last_drawn_;
  std::map<int, Running> running_;
  int next_id_ = 0;
  std::thread watcher_; ///< the last member: it uses the others
};

} // namespace asperity::run
