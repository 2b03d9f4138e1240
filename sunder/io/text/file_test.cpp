#include <sunder/base/error.h>
#include <sunder/io/text/file.h>

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

namespace sunder::io {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, removed at the end.
class File : public testing::Test {
 protected:
  File() {
    std::string name = (fs::temp_directory_path() / "sunder-file-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  ~File() override { fs::remove_all(folder_); }

  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

template <class Action>
void expect_error(Action action, const std::string& place, const std::string& fragment) {
  try {
    action();
    ADD_FAILURE() << "no error, expected: " << fragment;
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_TRUE(text.starts_with(place + ": ")) << text;
    EXPECT_NE(text.find(fragment), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

TEST_F(File, ReadsAllBytes) {
  std::string bytes;
  for (unsigned i = 0; i < 300'000; ++i) bytes += static_cast<char>(i * i >> 3);
  std::ofstream(folder_ / "x", std::ios::binary) << bytes;
  EXPECT_EQ(read_file(folder_ / "x"), bytes);
}

TEST_F(File, ReadsAPipe) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const pid_t child = fork();
  if (child == 0) {
    std::ofstream(pipe) << std::string(2'500'000, 'x');
    _exit(0);
  }
  EXPECT_EQ(read_file(pipe), std::string(2'500'000, 'x'));
  EXPECT_EQ(waitpid(child, nullptr, 0), child);
}

TEST_F(File, TellsWhyItCannotRead) {
  expect_error([&] { read_file(folder_ / "none"); }, (folder_ / "none").string(), "no such file");
  expect_error([&] { read_file(folder_); }, folder_.string(), "is a folder");
  expect_error([&] { read_file(""); }, "(no name)", "empty");
  std::ofstream(folder_ / "empty");
  expect_error([&] { read_file(folder_ / "empty"); }, (folder_ / "empty").string(), "the file is empty");
  expect_error([&] { read_file(folder_ / std::string(300, 'n')); }, (folder_ / std::string(300, 'n')).string(),
               "cannot be opened (");
  expect_error([&] { read_file(folder_ / "empty" / "x"); }, (folder_ / "empty" / "x").string(), "no such file");
  if (fs::exists("/proc/self/mem")) {
    expect_error([] { read_file("/proc/self/mem"); }, "/proc/self/mem", "cannot be read (");
  }
  if (geteuid() != 0) {
    std::ofstream(folder_ / "secret") << "x";
    fs::permissions(folder_ / "secret", fs::perms::none);
    expect_error([&] { read_file(folder_ / "secret"); }, (folder_ / "secret").string(), "check the permissions");
  }
}

TEST_F(File, RefusesAnEndlessDevice) {
  if (!fs::exists("/dev/zero")) GTEST_SKIP();
  expect_error([] { read_file("/dev/zero"); }, "/dev/zero", "more than 256 MiB");
}

TEST_F(File, WritesNewAndOld) {
  const fs::path file = folder_ / "x";
  write_file_atomically(file, "one");
  EXPECT_EQ(read_file(file), "one");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  write_file_atomically(file, std::string("t\0o", 3));
  EXPECT_EQ(read_file(file), std::string("t\0o", 3));
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(file_count(), 1u) << "a temporary file was left behind";
}

TEST_F(File, FollowsASymbolicLink) {
  write_file_atomically(folder_ / "x", "one");
  fs::create_directory(folder_ / "sub");
  fs::create_symlink("../x", folder_ / "sub" / "link");
  write_file_atomically(folder_ / "sub" / "link", "two");
  EXPECT_EQ(read_file(folder_ / "x"), "two");
  EXPECT_TRUE(fs::is_symlink(folder_ / "sub" / "link"));
}

TEST_F(File, WritesInTheCurrentFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  write_file_atomically("bare name", "text");
  EXPECT_EQ(read_file("bare name"), "text");
  fs::current_path(before);
}

TEST_F(File, WithoutCommitNothingIsWritten) {
  write_file_atomically(folder_ / "x", "one");
  {
    OutputFile file(folder_ / "x");
    file.write("tw");
    EXPECT_EQ(file_count(), 2u);
  }
  EXPECT_EQ(read_file(folder_ / "x"), "one");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, PieceByPiece) {
  OutputFile file(folder_ / "x");
  for (const char* piece : {"o", "n", "e"}) file.write(piece);
  EXPECT_FALSE(fs::exists(folder_ / "x"));
  file.commit();
  EXPECT_EQ(read_file(folder_ / "x"), "one");
}

TEST_F(File, UnfinishedFilesCanBeRemoved) {
  write_file_atomically(folder_ / "done", "one");
  for (int round = 0; round < 20; ++round) {  // places are given back
    OutputFile one(folder_ / "x"), other(folder_ / "y");
    one.write("text");
    EXPECT_EQ(file_count(), 3u);
    remove_unfinished_files();
    EXPECT_EQ(file_count(), 1u);
  }
  expect_error([&] { OutputFile file(folder_ / "no" / "x"); }, (folder_ / "no" / "x").string(),
               "check that the folder");
  remove_unfinished_files();
  EXPECT_EQ(read_file(folder_ / "done"), "one");
}

TEST_F(File, DoesNotReplaceADevice) {
  write_file_atomically("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(File, TellsWhyItCannotWrite) {
  expect_error([&] { write_file_atomically(folder_, "x"); }, folder_.string(), "is a folder");
  expect_error([&] { write_file_atomically("", "x"); }, "(no name)", "empty");
  expect_error([&] { write_file_atomically(folder_ / "no" / "x", "x"); }, (folder_ / "no" / "x").string(),
               "check that the folder exists");
  if (fs::exists("/dev/full")) {
    expect_error([] { write_file_atomically("/dev/full", "x"); }, "/dev/full", "cannot be written");
  }
  EXPECT_EQ(file_count(), 0u);
}

TEST_F(File, GivenFilesHaveTheirNamesAndNoOthers) {
  std::ofstream(folder_ / "there") << "on the disk";
  const std::string first = "one", second = "two";
  std::string written;
  {
    const GivenFiles given({{"a/b/link.stl", &first}, {"-", &second}, {"c/link.stl", &second}});
    InputFiles inputs;
    EXPECT_EQ(read_file("a/b/link.stl", &inputs), "one");
    EXPECT_EQ(read_file("/dev/stdin", &inputs), "two");
    ASSERT_EQ(inputs.size(), 2u);
    EXPECT_EQ(inputs[0].name, "a/b/link.stl");
    EXPECT_EQ(inputs[1].name, "-");
    EXPECT_TRUE(is_file("-"));
    EXPECT_FALSE(is_file(folder_ / "there"));
    expect_error([&] { read_file(folder_ / "there"); }, (folder_ / "there").string(), "none of the files");
    EXPECT_EQ(GivenFiles::now(), &given);
    EXPECT_EQ(given.name_with_end("b/link.stl"), "a/b/link.stl");
    EXPECT_EQ(given.name_with_end("link.stl"), "");    // of two
    EXPECT_EQ(given.name_with_end("x/link.stl"), "");  // of none
    std::thread([&] {
      EXPECT_EQ(GivenFiles::now(), nullptr);
      EXPECT_EQ(read_file(folder_ / "there"), "on the disk");
    }).join();
    OutputFile out(folder_ / "out", [&](std::string_view text) { written += text; });
    out.write("a ");
    out.write("proof");
    out.commit();
  }
  EXPECT_EQ(GivenFiles::now(), nullptr);
  EXPECT_EQ(written, "a proof");
  EXPECT_EQ(file_count(), 1u);
  EXPECT_EQ(read_file(folder_ / "there"), "on the disk");
}

}  // namespace
}  // namespace sunder::io
