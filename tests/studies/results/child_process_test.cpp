#include "studies/results/child_process.hpp"

#include <csignal>

#include <gtest/gtest.h>
#include <unistd.h>

namespace unbruised::studies {
namespace {

ResultsError ending_of(const std::function<std::string()>& body) {
  const auto answer = in_child_process("results.h5", body);
  EXPECT_FALSE(answer);
  return answer ? ResultsError{} : answer.error();
}

TEST(ChildProcess, AChildAnswersWithAnyBytes) {
  const std::string text("a\0b\n", 4);
  EXPECT_EQ(*in_child_process("results.h5", [&] { return text; }), text);
  const std::string large(std::size_t{1} << 22, 'x');  // far more than a pipe holds
  EXPECT_EQ(*in_child_process("results.h5", [&] { return large; }), large);
}

TEST(ChildProcess, ACrashOfTheLibraryIsDamageOfTheFile) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGXCPU, SIGKILL}) {
    const ResultsError error = ending_of([signal] {
      ::signal(signal, SIG_DFL);
      ::raise(signal);
      return std::string();
    });
    EXPECT_EQ(error.kind, ResultsErrorKind::damaged);
    EXPECT_NE(error.message.find("results.h5"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("HDF5 library"), std::string::npos) << error.message;
  }
}

TEST(ChildProcess, AnEndWithoutAnAnswerIsDamageToo) {
  EXPECT_EQ(ending_of([]() -> std::string { throw 1; }).kind, ResultsErrorKind::damaged);
  EXPECT_EQ(ending_of([]() -> std::string { ::_exit(0); }).kind, ResultsErrorKind::damaged);
}

}  // namespace
}  // namespace unbruised::studies
