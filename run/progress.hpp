#pragma once

// Shows the progress of a run: a bar on a terminal, one line per step in a
// pipe, and the remaining time. While a long step is at work, it is shown that
// it is, and for how long. The class owns the clock of the run.

#include "results/types/result.hpp"
#include "run/remaining_work.hpp"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace asperity::run {

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
