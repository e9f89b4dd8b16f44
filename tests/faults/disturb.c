/* Runs a program and disturbs one of its system calls: the call fails, transfers only half of its bytes, or is the moment of a kill.

   disturb [--after NAME | --on-signal] [--log FILE] [--call NAME --nth N (--error NUMBER | --short | --kill | --pause) [--from]] PROGRAM ARGUMENT...

   --after NAME   counts from the first call with a path that has NAME in it; what the loader does before is left alone
   --on-signal    counts from the first SIGUSR1 to this process
   --nth N        the N-th call of this name, over all threads, of those that can be disturbed (see below)
   --from         the N-th and all after it
   --short        halves the count of read, pread64, write, pwrite64; leaves one vector to readv, writev and their kin
   --kill         SIGKILL to the program before the call
   --pause        holds the program before the call until a SIGUSR1 to this process
   --log FILE     what was disturbed; without --call all that can be disturbed:
                  NAME NTH THREAD NTH_OF_THREAD FLAGS PATH. NTH_OF_THREAD counts as `strace -f -e inject=NAME:when=` does.

   Calls on file descriptors are disturbed where the descriptor is a file or a folder: a count of 4 at an eventfd, or an error of the disk at
   a socket, is nothing that a system would do. The exit status is that of the program, 128 + N for a signal. Linux 5.3, x86-64 or aarch64. */

#define _GNU_SOURCE
#include <errno.h>
#include <elf.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ptrace.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#define LENGTH(a) (sizeof(a) / sizeof((a)[0]))

/* What a call is about: a descriptor in its first argument, a path in argument 0 or 1, or neither. */
enum about { FD, PATH, PATH_AT, NEITHER };

struct call {
  const char *name;
  long number;
  enum about about;
  /* Which argument is a count that may be halved (bytes), or cut to one (vectors); 0 for none. */
  int bytes, vectors;
};

static const struct call CALLS[] = {
    {"write", SYS_write, FD, 2, 0},
    {"pwrite64", SYS_pwrite64, FD, 2, 0},
    {"writev", SYS_writev, FD, 0, 2},
    {"pwritev", SYS_pwritev, FD, 0, 2},
    {"read", SYS_read, FD, 2, 0},
    {"pread64", SYS_pread64, FD, 2, 0},
    {"readv", SYS_readv, FD, 0, 2},
    {"preadv", SYS_preadv, FD, 0, 2},
    {"fsync", SYS_fsync, FD, 0, 0},
    {"fdatasync", SYS_fdatasync, FD, 0, 0},
    {"ftruncate", SYS_ftruncate, FD, 0, 0},
    {"fallocate", SYS_fallocate, FD, 0, 0},
    {"copy_file_range", SYS_copy_file_range, FD, 0, 0},
    {"fchmod", SYS_fchmod, FD, 0, 0},
    {"fchown", SYS_fchown, FD, 0, 0},
    {"flock", SYS_flock, FD, 0, 0},
    {"fcntl", SYS_fcntl, FD, 0, 0},
    {"fstat", SYS_fstat, FD, 0, 0},
    {"getdents64", SYS_getdents64, FD, 0, 0},
    {"lseek", SYS_lseek, FD, 0, 0},
    {"openat", SYS_openat, PATH_AT, 0, 0},
    {"statx", SYS_statx, PATH_AT, 0, 0},
    {"newfstatat", SYS_newfstatat, PATH_AT, 0, 0},
    {"renameat", SYS_renameat, PATH_AT, 0, 0},
    {"renameat2", SYS_renameat2, PATH_AT, 0, 0},
    {"mkdirat", SYS_mkdirat, PATH_AT, 0, 0},
    {"unlinkat", SYS_unlinkat, PATH_AT, 0, 0},
    {"linkat", SYS_linkat, PATH_AT, 0, 0},
    {"fchmodat", SYS_fchmodat, PATH_AT, 0, 0},
    {"readlinkat", SYS_readlinkat, PATH_AT, 0, 0},
#ifdef SYS_open
    {"open", SYS_open, PATH, 0, 0},
    {"stat", SYS_stat, PATH, 0, 0},
    {"lstat", SYS_lstat, PATH, 0, 0},
    {"rename", SYS_rename, PATH, 0, 0},
    {"mkdir", SYS_mkdir, PATH, 0, 0},
    {"rmdir", SYS_rmdir, PATH, 0, 0},
    {"unlink", SYS_unlink, PATH, 0, 0},
    {"link", SYS_link, PATH, 0, 0},
    {"chmod", SYS_chmod, PATH, 0, 0},
    {"readlink", SYS_readlink, PATH, 0, 0},
#endif
    {"mmap", SYS_mmap, NEITHER, 0, 0},
    {"mprotect", SYS_mprotect, NEITHER, 0, 0},
    {"getrandom", SYS_getrandom, NEITHER, 0, 0},
    {"clone", SYS_clone, NEITHER, 0, 0},
    {"clone3", SYS_clone3, NEITHER, 0, 0},
};

struct thread {
  pid_t id;
  int is_new;
  /* Of the call that it is in. */
  int is_failed, is_halved;
  unsigned long long count;
  int argument;
  unsigned made[LENGTH(CALLS)];
};

static struct thread threads[4096];
static size_t thread_count;
static unsigned counted[LENGTH(CALLS)];
static volatile sig_atomic_t is_counting = 1, signals;
static pid_t child;
static FILE *out;

static const char *after, *wanted;
static unsigned nth;
static int error_number, is_short, is_kill, is_pause, is_from;

static void end(const char *what) {
  fprintf(stderr, "disturb: %s: %s\n", what, strerror(errno));
  if (child > 0) kill(child, SIGKILL);
  exit(125);
}

static void begin_counting(int signal_number) {
  (void)signal_number;
  is_counting = 1;
  signals++;
}

static void pass_on(int signal_number) { kill(child, signal_number); }

static struct thread *thread_of(pid_t id) {
  for (size_t k = 0; k < thread_count; k++)
    if (threads[k].id == id) return &threads[k];
  if (thread_count == LENGTH(threads)) end("too many threads");
  struct thread *made = &threads[thread_count++];
  memset(made, 0, sizeof *made);
  made->id = id;
  made->is_new = 1;
  return made;
}

/* A text in the memory of a thread; empty where there is none. */
static void read_text(pid_t id, unsigned long long at, char *text, size_t size) {
  size_t length = 0;
  text[0] = 0;
  while (at && length + 1 < size) {
    /* Not beyond the end of a page, behind which there may be nothing. */
    size_t piece = 4096 - (at + length) % 4096;
    if (piece > size - 1 - length) piece = size - 1 - length;
    struct iovec here = {text + length, piece}, there = {(void *)(uintptr_t)(at + length), piece};
    ssize_t got = process_vm_readv(id, &here, 1, &there, 1, 0);
    if (got <= 0) break;
    text[length + (size_t)got] = 0;
    if (strlen(text + length) < (size_t)got) return;
    length += (size_t)got;
  }
  text[length] = 0;
}

static void descriptor_path(pid_t id, long long descriptor, char *path, size_t size) {
  char link[64];
  snprintf(link, sizeof link, "/proc/%d/fd/%lld", id, descriptor);
  ssize_t length = readlink(link, path, size - 1);
  path[length < 0 ? 0 : length] = 0;
}

static int is_file_or_folder(pid_t id, long long descriptor) {
  char link[64];
  struct stat found;
  snprintf(link, sizeof link, "/proc/%d/fd/%lld", id, descriptor);
  return stat(link, &found) == 0 && (S_ISREG(found.st_mode) || S_ISDIR(found.st_mode));
}

/* Writes argument `index` of the call that the thread enters or has left; `number` -1 keeps the system from making the call. */
static void set_argument(pid_t id, int index, unsigned long long value) {
#if defined(__x86_64__)
  struct user_regs_struct registers;
  if (ptrace(PTRACE_GETREGS, id, 0, &registers)) end("registers");
  if (index == 1) registers.rsi = value;
  if (index == 2) registers.rdx = value;
  if (ptrace(PTRACE_SETREGS, id, 0, &registers)) end("registers");
#elif defined(__aarch64__)
  struct user_regs_struct registers;
  struct iovec all = {&registers, sizeof registers};
  if (ptrace(PTRACE_GETREGSET, id, NT_PRSTATUS, &all)) end("registers");
  registers.regs[index] = value;
  if (ptrace(PTRACE_SETREGSET, id, NT_PRSTATUS, &all)) end("registers");
#else
#error "x86-64 or aarch64"
#endif
}

static void leave_out(pid_t id) {
#if defined(__x86_64__)
  struct user_regs_struct registers;
  if (ptrace(PTRACE_GETREGS, id, 0, &registers)) end("registers");
  registers.orig_rax = (unsigned long long)-1;
  if (ptrace(PTRACE_SETREGS, id, 0, &registers)) end("registers");
#elif defined(__aarch64__)
  int number = -1;
  struct iovec one = {&number, sizeof number};
  if (ptrace(PTRACE_SETREGSET, id, NT_ARM_SYSTEM_CALL, &one)) end("registers");
#endif
}

static void set_result(pid_t id, long long value) {
#if defined(__x86_64__)
  struct user_regs_struct registers;
  if (ptrace(PTRACE_GETREGS, id, 0, &registers)) end("registers");
  registers.rax = (unsigned long long)value;
  if (ptrace(PTRACE_SETREGS, id, 0, &registers)) end("registers");
#elif defined(__aarch64__)
  set_argument(id, 0, (unsigned long long)value);
#endif
}

/* Whether a path has a name in it, as a whole. */
static int has_name(const char *path, const char *name) {
  for (const char *at = path; (at = strstr(at, name)); at++) {
    char next = at[strlen(name)];
    if ((at == path || at[-1] == '/') && (!next || next == '/')) return 1;
  }
  return 0;
}

static void enter(struct thread *thread, long number, const unsigned long long *arguments) {
  size_t which = 0;
  while (which < LENGTH(CALLS) && CALLS[which].number != number) which++;
  if (which == LENGTH(CALLS)) return;
  const struct call *call = &CALLS[which];
  unsigned made = ++thread->made[which];
  char path[PATH_MAX] = "";
  int is_open = 1;
  if (call->about == PATH || call->about == PATH_AT) read_text(thread->id, arguments[call->about == PATH_AT], path, sizeof path);
  if (call->about == FD || (call->about == PATH_AT && !path[0])) {
    is_open = is_file_or_folder(thread->id, (int)arguments[0]);
    descriptor_path(thread->id, (int)arguments[0], path, sizeof path);
  }
  if (!is_counting && after && has_name(path, after)) is_counting = 1;
  if (!is_counting || !is_open) return;
  unsigned long long count = arguments[call->bytes ? call->bytes : call->vectors];
  if (is_short && ((!call->bytes && !call->vectors) || count < 2)) return;
  unsigned place = ++counted[which];
  /* A disk that has failed for good says nothing against the terminal. */
  int is_terminal = call->about == FD && arguments[0] <= 2;
  int is_wanted = wanted && strcmp(wanted, call->name) == 0 && (place == nth || (is_from && place > nth && !is_terminal));
  if (out && (is_wanted || !wanted)) {
    unsigned long long flags = number == SYS_openat ? arguments[2] : call->bytes ? count : 0;
    fprintf(out, "%s\t%u\t%zu\t%u\t%llu\t%s\n", call->name, place, (size_t)(thread - threads), made, flags, path);
    fflush(out);
  }
  if (!is_wanted) return;
  if (is_kill) {
    kill(child, SIGKILL);
  } else if (is_pause) {
    /* The other side signals after it has read the log. */
    while (!signals) usleep(1000);
  } else if (is_short) {
    thread->is_halved = 1;
    thread->argument = call->bytes ? call->bytes : call->vectors;
    thread->count = count;
    set_argument(thread->id, thread->argument, call->bytes ? count / 2 : 1);
  } else {
    thread->is_failed = 1;
    leave_out(thread->id);
  }
}

static void leave(struct thread *thread) {
  if (thread->is_failed) set_result(thread->id, -error_number);
  /* The program may rely on its arguments after the call. */
  if (thread->is_halved) set_argument(thread->id, thread->argument, thread->count);
  thread->is_failed = thread->is_halved = 0;
}

/* The structure of PTRACE_GET_SYSCALL_INFO, which not every <sys/ptrace.h> has. */
struct syscall_info {
  uint8_t op, pad[3];
  uint32_t arch;
  uint64_t instruction_pointer, stack_pointer;
  uint64_t number, arguments[6];
  uint64_t more[4];
};

static int follow(void) {
  int ended = -1;
  for (;;) {
    int status;
    pid_t id = waitpid(-1, &status, __WALL);
    if (id < 0 && errno == EINTR) continue;
    if (id < 0) return ended;
    if (WIFEXITED(status) || WIFSIGNALED(status)) {
      if (id == child) ended = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      for (size_t k = 0; k < thread_count; k++)
        if (threads[k].id == id) threads[k].id = 0;
      continue;
    }
    struct thread *thread = thread_of(id);
    int stop = WSTOPSIG(status), deliver = 0;
    if (stop == (SIGTRAP | 0x80)) {
      struct syscall_info info;
      if (ptrace(0x420e /* PTRACE_GET_SYSCALL_INFO */, id, sizeof info, &info) > 0) {
        if (info.op == 1) {
          unsigned long long arguments[6];
          for (int k = 0; k < 6; k++) arguments[k] = info.arguments[k];
          enter(thread, (long)info.number, arguments);
        } else if (info.op == 2) {
          leave(thread);
        }
      }
    } else if (status >> 16) {
      /* A thread, a process or a program begins. */
    } else if (stop == SIGSTOP && thread->is_new) {
      /* Every new thread begins so. */
    } else {
      deliver = stop;
    }
    thread->is_new = 0;
    /* It may have been killed meanwhile. */
    ptrace(PTRACE_SYSCALL, id, 0, deliver);
  }
}

int main(int count, char **arguments) {
  int k = 1;
  for (; k < count && arguments[k][0] == '-'; k++) {
    const char *flag = arguments[k];
    if (!strcmp(flag, "--short")) is_short = 1;
    else if (!strcmp(flag, "--kill")) is_kill = 1;
    else if (!strcmp(flag, "--pause")) is_pause = 1;
    else if (!strcmp(flag, "--from")) is_from = 1;
    else if (!strcmp(flag, "--on-signal")) is_counting = 0;
    else if (k + 1 == count) break;
    else if (!strcmp(flag, "--after")) after = arguments[++k], is_counting = 0;
    else if (!strcmp(flag, "--call")) wanted = arguments[++k];
    else if (!strcmp(flag, "--nth")) nth = (unsigned)atoi(arguments[++k]);
    else if (!strcmp(flag, "--error")) error_number = atoi(arguments[++k]);
    else if (!strcmp(flag, "--log")) {
      out = fopen(arguments[++k], "we");
      if (!out) end(arguments[k]);
    } else break;
  }
  if (k >= count || arguments[k][0] == '-') {
    fprintf(stderr, "usage: see the head of tests/faults/disturb.c\n");
    return 125;
  }
  child = fork();
  if (child < 0) end("fork");
  if (child == 0) {
    if (ptrace(PTRACE_TRACEME, 0, 0, 0)) _exit(125);
    raise(SIGSTOP);
    execvp(arguments[k], arguments + k);
    perror(arguments[k]);
    _exit(125);
  }
  struct sigaction begin = {.sa_handler = begin_counting}, pass = {.sa_handler = pass_on};
  sigaction(SIGUSR1, &begin, 0);
  sigaction(SIGTERM, &pass, 0);
  sigaction(SIGINT, &pass, 0);
  int status;
  if (waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) end("start");
  thread_of(child)->is_new = 0;
  long options = PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACECLONE | PTRACE_O_TRACEFORK | PTRACE_O_TRACEVFORK | PTRACE_O_TRACEEXEC |
                 PTRACE_O_EXITKILL;
  if (ptrace(PTRACE_SETOPTIONS, child, 0, options)) end("ptrace");
  ptrace(PTRACE_SYSCALL, child, 0, 0);
  status = follow();
  if (out) {
    fprintf(out, "ended\t%d\n", status);
    fclose(out);
  }
  return status;
}
