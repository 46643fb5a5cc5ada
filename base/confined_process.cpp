#include "base/confined_process.hpp"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>
#include <vector>

namespace asperity {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;
#endif

constexpr const char* starts_a_program = "starts a program";
constexpr const char* writes_a_file = "writes a file";
constexpr const char* changes_files = "creates, changes or removes a file";
constexpr const char* uses_the_network = "uses the network";

struct ForbiddenCall {
  long number;
  const char* what;
  int file; ///< index of the argument with its name; -1: none
};

/// The calls that are forbidden whatever their arguments. Processors other than
/// x86-64 have only those that name a folder ("at").
constexpr ForbiddenCall forbidden_calls[] = {
#ifdef SYS_open
    {SYS_fork, starts_a_program, -1},       {SYS_vfork, starts_a_program, -1},
    {SYS_creat, writes_a_file, 0},          {SYS_mkdir, changes_files, 0},
    {SYS_mknod, changes_files, 0},          {SYS_rename, changes_files, 0},
    {SYS_link, changes_files, 1},           {SYS_symlink, changes_files, 1},
    {SYS_unlink, changes_files, 0},         {SYS_rmdir, changes_files, 0},
    {SYS_chmod, changes_files, 0},          {SYS_chown, changes_files, 0},
    {SYS_lchown, changes_files, 0},
#endif
#ifdef SYS_renameat
    {SYS_renameat, changes_files, 1},
#endif
    {SYS_execve, starts_a_program, 0},      {SYS_execveat, starts_a_program, 1},
    {SYS_mkdirat, changes_files, 1},        {SYS_mknodat, changes_files, 1},
    {SYS_renameat2, changes_files, 1},      {SYS_linkat, changes_files, 3},
    {SYS_symlinkat, changes_files, 2},      {SYS_unlinkat, changes_files, 1},
    {SYS_truncate, changes_files, 0},       {SYS_fchmodat, changes_files, 1},
    {SYS_fchownat, changes_files, 1},       {SYS_socket, uses_the_network, -1},
    {SYS_socketpair, uses_the_network, -1},
};

/// Calls that fail as on an older kernel, because a filter cannot read their
/// arguments; the libraries then use the calls that it can read.
constexpr long unknown_calls[] = {SYS_clone3, SYS_openat2, SYS_io_uring_setup};

constexpr std::uint32_t writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
/// A clone is a thread, or the helper with which a sanitizer inspects its own
/// process.
constexpr std::uint32_t not_a_program = CLONE_THREAD | CLONE_UNTRACED;

OnForbidden report_act = nullptr;

using Filter = std::vector<sock_filter>;

void load(Filter& filter, std::size_t offset) {
  filter.push_back(
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
}

/// Ends with `answer` if the loaded number passes the test.
void answer_if(Filter& filter, std::uint16_t test, std::uint32_t operand,
               std::uint32_t answer) {
  filter.push_back(BPF_JUMP(BPF_JMP | test | BPF_K, operand, 0, 1));
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, answer));
}

/// The lower half of an argument, on little-endian processors.
constexpr std::size_t offset_of_argument(std::size_t argument) {
  return offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t);
}

/// Lets a call trap, or not, if an argument has one of the bits.
void trap_by_bits(Filter& filter, long call, std::size_t argument,
                  std::uint32_t bits, bool traps_with_bit) {
  constexpr std::uint8_t n_skipped = 4;
  filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K,
                            static_cast<std::uint32_t>(call), 0, n_skipped));
  load(filter, offset_of_argument(argument));
  answer_if(filter, BPF_JSET, bits,
            traps_with_bit ? SECCOMP_RET_TRAP : SECCOMP_RET_ALLOW);
  filter.push_back(BPF_STMT(
      BPF_RET | BPF_K, traps_with_bit ? SECCOMP_RET_ALLOW : SECCOMP_RET_TRAP));
}

Filter filter_of_calls() {
  Filter filter;
  load(filter, offsetof(seccomp_data, arch));
  filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0));
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  load(filter, offsetof(seccomp_data, nr));
#ifdef __x86_64__
  constexpr std::uint32_t x32_bit = 0x40000000; // the 32-bit interface
  answer_if(filter, BPF_JGE, x32_bit, SECCOMP_RET_KILL_PROCESS);
#endif
  for (const ForbiddenCall& call : forbidden_calls)
    answer_if(filter, BPF_JEQ, static_cast<std::uint32_t>(call.number),
              SECCOMP_RET_TRAP);
  for (const long call : unknown_calls)
    answer_if(filter, BPF_JEQ, static_cast<std::uint32_t>(call),
              SECCOMP_RET_ERRNO | ENOSYS);
#ifdef SYS_open
  trap_by_bits(filter, SYS_open, 1, writing, true);
#endif
  trap_by_bits(filter, SYS_openat, 2, writing, true);
  trap_by_bits(filter, SYS_clone, 0, not_a_program, false);
  filter.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  return filter;
}

std::uint64_t argument_of(const ucontext_t& context, int index) {
#if defined(__x86_64__)
  constexpr int registers[] = {REG_RDI, REG_RSI, REG_RDX, REG_R10};
  return static_cast<std::uint64_t>(
      context.uc_mcontext.gregs[registers[index]]);
#elif defined(__aarch64__)
  return context.uc_mcontext.regs[index];
#else
  static_cast<void>(context);
  static_cast<void>(index);
  return 0;
#endif
}

void set_result(ucontext_t& context, int result) {
#if defined(__x86_64__)
  context.uc_mcontext.gregs[REG_RAX] = result;
#elif defined(__aarch64__)
  context.uc_mcontext.regs[0] = static_cast<std::uint64_t>(result);
#else
  static_cast<void>(context);
  static_cast<void>(result);
#endif
}

ForbiddenCall call_of(long number) {
  for (const ForbiddenCall& call : forbidden_calls)
    if (call.number == number)
      return call;
#ifdef SYS_open
  if (number == SYS_open)
    return {number, writes_a_file, 0};
#endif
  return number == SYS_openat ? ForbiddenCall{number, writes_a_file, 1}
                              : ForbiddenCall{number, starts_a_program, -1};
}

bool removes(long number) {
#ifdef SYS_open
  if (number == SYS_unlink)
    return true;
#endif
  return number == SYS_unlinkat;
}

void on_trap(int, siginfo_t* info, void* context) {
  auto& state = *static_cast<ucontext_t*>(context);
  const ForbiddenCall call = call_of(info->si_syscall);
  const char* file = nullptr;
  if (call.file >= 0) // NOLINTNEXTLINE(performance-no-int-to-ptr): a register
    file = reinterpret_cast<const char*>(argument_of(state, call.file));
  if (file != nullptr && removes(call.number) &&
      faccessat(AT_FDCWD, file, F_OK, AT_SYMLINK_NOFOLLOW) != 0) {
    set_result(state, -ENOENT);
    return;
  }
  report_act({call.what, file});
  constexpr int unexpected_return = 4;
  _exit(unexpected_return);
}

} // namespace

bool confine_process(OnForbidden report) {
  if (architecture == 0)
    return false;
  report_act = report;

  struct sigaction action {};

  action.sa_sigaction = on_trap;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, nullptr);
  Filter filter = filter_of_calls();
  const sock_fprog program{static_cast<unsigned short>(filter.size()),
                           filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER,
                 SECCOMP_FILTER_FLAG_TSYNC, &program) == 0;
}

} // namespace asperity
