/* Preloaded into the program: counts the calls that change files below one directory, and lets the Nth one fail.
 *
 *   UNBRUISED_FAULT_BELOW   the directory, an absolute path as the program spells it
 *   UNBRUISED_FAULT_AT      which call, from 1; 0 or unset: none, calls are only counted
 *   UNBRUISED_FAULT_KIND    kill   kill -9 before the call
 *                           torn   half of the write, then kill -9; of other calls: the call, then kill -9
 *                           full   half of the write, then ENOSPC from there on
 *                           quota  the same with EDQUOT
 *                           eio    EIO, once
 *                           denied EACCES from there on
 *   UNBRUISED_FAULT_LOG     gets a line "ack <size> <path>" after each fdatasync of a journal (so many bytes of it are
 *                           acknowledged), and "calls <count>" at a normal end
 */
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

enum { kFilesMost = 4096 };

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static char *path_of[kFilesMost]; /* of files below the directory; else NULL */
static long calls = 0;
static long fault_at = 0;
static const char *kind = "";
static const char *below = NULL;
static int log_file = -1;
static int failing = 0; /* errno from there on */

__attribute__((constructor)) static void begin(void) {
  const char *at = getenv("UNBRUISED_FAULT_AT");
  const char *log = getenv("UNBRUISED_FAULT_LOG");
  fault_at = at != NULL ? atol(at) : 0;
  kind = getenv("UNBRUISED_FAULT_KIND") != NULL ? getenv("UNBRUISED_FAULT_KIND") : "";
  below = getenv("UNBRUISED_FAULT_BELOW");
  if (log != NULL) log_file = (int)syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
}

static void say(const char *text) {
  if (log_file >= 0) (void)!syscall(SYS_write, log_file, text, strlen(text));
}

__attribute__((destructor)) static void end(void) {
  char line[64];
  snprintf(line, sizeof line, "calls %ld\n", calls);
  say(line);
}

static int is_below(const char *path) {
  return below != NULL && path != NULL && strncmp(path, below, strlen(below)) == 0;
}

static void die(void) {
  kill(getpid(), SIGKILL);
  for (;;) pause();
}

/* What happens to this call. */
enum Fate { kWorks, kTorn, kHalf, kFails };

static enum Fate fate(void) {
  enum Fate result = kWorks;
  pthread_mutex_lock(&mutex);
  const long number = ++calls;
  if (failing != 0) {
    errno = failing;
    result = kFails;
  } else if (number == fault_at) {
    if (strcmp(kind, "kill") == 0) die();
    if (strcmp(kind, "torn") == 0) result = kTorn;
    if (strcmp(kind, "full") == 0) failing = ENOSPC;
    if (strcmp(kind, "quota") == 0) failing = EDQUOT;
    if (failing != 0) result = kHalf;
    if (strcmp(kind, "denied") == 0) {
      errno = failing = EACCES;
      result = kFails;
    }
    if (strcmp(kind, "eio") == 0) {
      errno = EIO;
      result = kFails;
    }
  }
  pthread_mutex_unlock(&mutex);
  return result;
}

/* For calls that write nothing: a full disk refuses them at once. */
static enum Fate fate_of_name(void) {
  enum Fate result = fate();
  if (result == kHalf) {
    errno = failing;
    return kFails;
  }
  return result;
}

static void remember(int file, const char *path) {
  if (file < 0 || file >= kFilesMost) return;
  free(path_of[file]);
  path_of[file] = strdup(path);
}

static int is_ours(int file) { return file >= 0 && file < kFilesMost && path_of[file] != NULL; }

static int open_any(const char *path, int flags, mode_t mode) {
  if (!is_below(path)) return (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
  enum Fate end = (flags & O_CREAT) != 0 ? fate_of_name() : kWorks;
  if (end == kFails) return -1;
  int file = (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
  if (end == kTorn) die();
  remember(file, path);
  return file;
}

#define OPEN(name)                                  \
  int name(const char *path, int flags, ...) {      \
    mode_t mode = 0;                                \
    if ((flags & (O_CREAT | O_TMPFILE)) != 0) {     \
      va_list more;                                 \
      va_start(more, flags);                        \
      mode = va_arg(more, mode_t);                  \
      va_end(more);                                 \
    }                                               \
    return open_any(path, flags, mode);             \
  }
OPEN(open)
OPEN(open64)

int close(int file) {
  if (is_ours(file)) {
    free(path_of[file]);
    path_of[file] = NULL;
  }
  return (int)syscall(SYS_close, file);
}

static ssize_t write_any(int file, const void *bytes, size_t size, off_t at) {
  enum Fate end = is_ours(file) ? fate() : kWorks;
  if (end == kFails) return -1;
  if (end != kWorks) size /= 2;
  ssize_t written = 0;
  if (size > 0 || end == kWorks) {
    written = at >= 0 ? syscall(SYS_pwrite64, file, bytes, size, at) : syscall(SYS_write, file, bytes, size);
  }
  if (end == kTorn) die();
  if (end == kHalf && written == 0) {
    errno = failing;
    return -1;
  }
  return written;
}

ssize_t write(int file, const void *bytes, size_t size) { return write_any(file, bytes, size, -1); }
ssize_t pwrite(int file, const void *bytes, size_t size, off_t at) { return write_any(file, bytes, size, at); }
ssize_t pwrite64(int file, const void *bytes, size_t size, off_t at) { return write_any(file, bytes, size, at); }

/* A call without bytes: works or fails as a whole. A disk that is full still lets a file be cut. */
#define PLAIN(name, parameters, ours, enough, call) \
  int name parameters {                             \
    enum Fate end = (ours) ? enough() : kWorks;     \
    if (end == kFails) return -1;                   \
    int result = (int)(call);                       \
    if (end == kTorn) die();                        \
    return result;                                  \
  }

static enum Fate fate_of_cut(void) {
  enum Fate result = fate();
  if (result == kHalf || (result == kFails && (errno == ENOSPC || errno == EDQUOT))) return kWorks;
  return result;
}

PLAIN(ftruncate, (int file, off_t size), is_ours(file), fate_of_cut, syscall(SYS_ftruncate, file, size))
PLAIN(ftruncate64, (int file, off_t size), is_ours(file), fate_of_cut, syscall(SYS_ftruncate, file, size))
PLAIN(fsync, (int file), is_ours(file), fate_of_name, syscall(SYS_fsync, file))
PLAIN(rename, (const char *from, const char *to), is_below(from), fate_of_name, syscall(SYS_rename, from, to))
PLAIN(link, (const char *from, const char *to), is_below(to), fate_of_name, syscall(SYS_link, from, to))
PLAIN(unlink, (const char *path), is_below(path), fate_of_cut, syscall(SYS_unlink, path))
PLAIN(mkdir, (const char *path, mode_t mode), is_below(path), fate_of_name, syscall(SYS_mkdir, path, mode))

int fdatasync(int file) {
  if (!is_ours(file)) return (int)syscall(SYS_fdatasync, file);
  struct stat state;
  const int known = fstat(file, &state); /* what is written now is what a success acknowledges */
  char name[1024];
  snprintf(name, sizeof name, "%s", path_of[file]);
  enum Fate end = fate_of_name();
  if (end == kFails) return -1;
  const int result = (int)syscall(SYS_fdatasync, file);
  if (result == 0 && known == 0) {
    char line[1100];
    snprintf(line, sizeof line, "ack %lld %s\n", (long long)state.st_size, name);
    say(line);
  }
  if (end == kTorn) die();
  return result;
}
