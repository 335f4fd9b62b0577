// SPDX-License-Identifier: Apache-2.0
#include "io/output_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>

#include "io/error.hpp"
#include "io/output_file.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "halfspace-folder-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    base_ = name;
  }
  void TearDown() override { fs::remove_all(base_); }

  // Everything below the base, relative to it.
  std::set<std::string> tree() const {
    std::set<std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(base_)) {
      out.insert(fs::relative(entry.path(), base_).string());
    }
    return out;
  }
  static void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  // Not by read_file(): what that reads is an input, and no output may replace it.
  static std::string text(const fs::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  // The exit status of a process that does the work with the handlers of the program.
  template <class Work>
  static int in_child(Work&& work) {
    const pid_t child = fork();
    if (child == 0) {
      if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(9);
      handle_interrupts();
      work();
      _exit(7);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path base_;
};

TEST_F(OutputFolderTest, NothingIsInPlaceBeforeCommitAndEverythingAfter) {
  OutputFolder folder((base_ / "a/b/out/").string());
  put(folder.file("one"), "1");
  put(folder.file("two"), "2");
  folder.file("never written");
  EXPECT_FALSE(fs::exists(base_ / "a/b/out"));
  folder.commit();
  EXPECT_EQ(tree(), (std::set<std::string>{"a", "a/b", "a/b/out", "a/b/out/one", "a/b/out/two"}));
  EXPECT_EQ(text(base_ / "a/b/out/two"), "2");
}

TEST_F(OutputFolderTest, AnInputStaysWhatItIs) {
  fs::create_directory(base_ / "out");
  put(base_ / "out/one", "input");
  put(base_ / "out/two", "old");
  fs::create_hard_link(base_ / "out/one", base_ / "out/hard");
  EXPECT_EQ(read_file((base_ / "out/hard").string()), "input");
  {
    OutputFolder folder((base_ / "out").string());
    put(folder.file("two"), "new");
    put(folder.file("one"), "new");
    EXPECT_THROW(folder.commit(), Error);
  }
  EXPECT_THROW(OutputFile((base_ / "out/one").string()), Error);
  EXPECT_EQ(text(base_ / "out/one"), "input");
  EXPECT_EQ(text(base_ / "out/two"), "old");
  OutputFile opened_before((base_ / "out/two").string());
  EXPECT_EQ(read_file((base_ / "out/two").string()), "old");
  EXPECT_THROW(opened_before.commit(), Error);
  // A file that has changed since is another one.
  put(base_ / "out/one", "changed by another program");
  EXPECT_NO_THROW(OutputFile((base_ / "out/one").string()));
}

TEST_F(OutputFolderTest, FolderThatIsThereKeepsWhatIsNotWrittenAnew) {
  fs::create_directory(base_ / "out");
  put(base_ / "out/mine", "kept");
  put(base_ / "out/one", "old");
  OutputFolder folder((base_ / "out").string());
  put(folder.file("one"), "new");
  folder.file("never written");
  EXPECT_EQ(text(base_ / "out/one"), "old");
  folder.commit();
  EXPECT_EQ(text(base_ / "out/one"), "new");
  EXPECT_EQ(tree(), (std::set<std::string>{"out", "out/mine", "out/one"}));
}

TEST_F(OutputFolderTest, DestroyedWithoutCommitLeavesNothing) {
  {
    OutputFolder folder((base_ / "a/b/out").string());
    put(folder.file("one"), "1");
    put(fs::path(folder.file("two")).parent_path() / "a library's own", "3");
  }
  EXPECT_EQ(tree(), std::set<std::string>{});
}

TEST_F(OutputFolderTest, FolderWithoutANameIsWritten) {
  const fs::path before = fs::current_path();
  fs::current_path(base_);
  OutputFolder folder(".");
  put(folder.file("one"), "1");
  folder.commit();
  fs::current_path(before);
  EXPECT_EQ(tree(), std::set<std::string>{"one"});
}

TEST_F(OutputFolderTest, WhatIsNoFolderIsRefused) {
  put(base_ / "file", "");
  for (const char* name : {"file", "file/out", "file/"}) {
    EXPECT_THROW(OutputFolder((base_ / name).string()), Error) << name;
  }
  EXPECT_THROW(OutputFolder(""), Error);
  EXPECT_EQ(tree(), std::set<std::string>{"file"});
}

TEST_F(OutputFolderTest, InterruptedLeavesNothing) {
  for (const int number : {SIGINT, SIGTERM, SIGABRT}) {
    EXPECT_EQ(in_child([&] {
                OutputFolder folder((base_ / "a/b/out").string());
                put(folder.file("one"), "1");
                OutputFile two(folder.file("two"));
                two.write("2");
                raise(number);
              }),
              2);
    EXPECT_EQ(tree(), std::set<std::string>{}) << "signal " << number;
  }
}

TEST_F(OutputFolderTest, EveryFileThatIsOpenWhenInterruptedIsRemoved) {
  EXPECT_EQ(in_child([&] {
              OutputFile first((base_ / "first").string());
              OutputFile done((base_ / "done").string());
              OutputFile last((base_ / "last").string());
              done.commit();
              raise(SIGINT);
            }),
            2);
  EXPECT_EQ(tree(), std::set<std::string>{"done"});
}

TEST_F(OutputFolderTest, ChildIsKilledWhenInterrupted) {
  const fs::path late = base_ / "late";
  EXPECT_EQ(in_child([&] {
              const pid_t child = fork();
              if (child == 0) {
                setpgid(0, 0);
                leave_interrupts();
                usleep(300000);
                put(late, "too late");
                _exit(0);
              }
              setpgid(child, child);
              kill_on_interrupt(child);
              raise(SIGTERM);
            }),
            2);
  usleep(500000);
  EXPECT_FALSE(fs::exists(late));
}

}  // namespace
}  // namespace halfspace
