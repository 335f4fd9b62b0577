// SPDX-License-Identifier: Apache-2.0
//
// A signal at the worst moment: between any two calls that make or place a file.
#include "io/interrupt.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "io/output_file.hpp"
#include "io/output_folder.hpp"

namespace {

std::atomic<int> calls_until_signal{0};  // 0: none

void count_call() {
  if (calls_until_signal > 0 && --calls_until_signal == 0) ::raise(SIGTERM);
}

}  // namespace

// In place of the C library's, for everything in this program and its libraries: the signal comes
// as they return.
#pragma GCC visibility push(default)
extern "C" int rename(const char* from, const char* to) noexcept {
  const int result = ::renameat(AT_FDCWD, from, AT_FDCWD, to);
  count_call();
  return result;
}

extern "C" std::FILE* fopen(const char* path, const char* mode) {
  using Open = std::FILE* (*)(const char*, const char*);
  static const auto real = reinterpret_cast<Open>(::dlsym(RTLD_NEXT, "fopen"));
  std::FILE* file = real(path, mode);
  count_call();
  return file;
}

extern "C" int mkdir(const char* path, mode_t mode) noexcept {
  const int result = ::mkdirat(AT_FDCWD, path, mode);
  count_call();
  return result;
}

#pragma GCC visibility pop

namespace halfspace {
namespace {

namespace fs = std::filesystem;

class InterruptTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "halfspace-interrupt-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    base_ = name;
    fs::create_directory(base_ / "out");
    said_ = name + ".said";
  }
  void TearDown() override {
    fs::remove_all(base_);
    fs::remove(said_);
  }

  std::string text(const fs::path& path) const {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  // The work in a process of its own with a signal at its n-th call; 2: interrupted, 0: its end was
  // reached first.
  template <class Work>
  int interrupted_at(int call, Work&& work) {
    const pid_t child = fork();
    if (child == 0) {
      if (std::freopen(said_.c_str(), "w", stderr) == nullptr) _exit(9);
      handle_interrupts();
      calls_until_signal = call;
      work();
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path base_;
  std::string said_;
};

TEST_F(InterruptTest, OutputsAreAllThereOrNoneAndTheLineIsTrue) {
  const fs::path a = base_ / "out/a", b = base_ / "out/b", page = base_ / "out/page";
  int interrupted = 0;
  for (int call = 1;; ++call) {
    std::ofstream(a) << "old";
    std::ofstream(b) << "old";
    fs::remove_all(page);
    const int status = interrupted_at(call, [&] {
      OutputGroup outputs;
      outputs.open(a.string()).write("new");
      outputs.open(b.string()).write("new");
      outputs.commit();
      OutputFolder folder((page / "deep").string());
      write_text(folder.file("x"), "new");
      folder.commit();
      OutputFolder again((page / "deep").string());
      write_text(again.file("x"), "newer");
      write_text(again.file("y"), "newer");
      again.commit();
    });
    if (status == 0) break;
    ASSERT_EQ(status, 2) << "call " << call;
    ++interrupted;
    const bool files = text(a) == "new";
    EXPECT_EQ(text(b), files ? "new" : "old") << "call " << call;
    EXPECT_EQ(text(said_), files ? "halfspace: error[HS050]: interrupted; what was written before "
                                   "stays\n"
                                 : "halfspace: error[HS050]: interrupted; nothing was written\n")
        << "call " << call;
    if (fs::exists(page)) {
      EXPECT_EQ(text(page / "deep/x"), fs::exists(page / "deep/y") ? "newer" : "new") << call;
    }
    for (const auto& entry : fs::recursive_directory_iterator(base_)) {
      EXPECT_EQ(entry.path().string().find(".partial-"), std::string::npos) << entry.path();
    }
  }
  EXPECT_GE(interrupted, 12) << "two files opened and renamed, folders made and renamed";
}

TEST_F(InterruptTest, ASignalWaitsForEveryHoldAndComesThen) {
  EXPECT_EQ(interrupted_at(0,
                           [] {
                             const InterruptsHeld outer;
                             {
                               const InterruptsHeld inner;
                               ::raise(SIGHUP);
                             }
                             ::raise(SIGINT);
                             ::_exit(5);  // still alive
                           }),
            5);
  EXPECT_EQ(interrupted_at(0,
                           [] {
                             {
                               const InterruptsHeld held;
                               ::raise(SIGTERM);
                             }
                             ::_exit(5);
                           }),
            2);
}

// The handler may run in any thread.
TEST_F(InterruptTest, AnotherThreadsSignalWaitsToo) {
  EXPECT_EQ(interrupted_at(0,
                           [] {
                             {
                               const InterruptsHeld held;
                               std::thread([] { ::raise(SIGTERM); }).join();
                               ::write(STDERR_FILENO, "held\n", 5) == 5 ? void() : ::_exit(6);
                             }
                             ::_exit(5);
                           }),
            2);
  EXPECT_TRUE(text(said_).starts_with("held\nhalfspace: error[HS050]"));
}

}  // namespace
}  // namespace halfspace
