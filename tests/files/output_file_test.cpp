// SPDX-License-Identifier: Apache-2.0
#include "files/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <optional>

#include "../temporary_folder.h"
#include "error.h"

namespace pyrasim {
namespace {

using OutputFileTest = TemporaryFolder;

TEST_F(OutputFileTest, appears_when_committed) {
  OutputFile file(in_folder("a.txt"));
  file.write("one ");
  file.write("two");
  EXPECT_FALSE(std::filesystem::exists(in_folder("a.txt")));
  file.commit();
  EXPECT_EQ(contents(in_folder("a.txt")), "one two");
  EXPECT_EQ(entries(), 1);
}

TEST_F(OutputFileTest, more_than_the_buffer_arrives_whole) {
  std::string expected;
  {
    OutputFile file(in_folder("big"));
    for (int i = 0; i < 50000; ++i) {
      const std::string line = std::to_string(i) + "\n";
      file.write(line);
      expected += line;
    }
    file.commit();
  }
  EXPECT_EQ(contents(in_folder("big")), expected);
}

TEST_F(OutputFileTest, leaves_nothing_when_not_committed) {
  { OutputFile(in_folder("a.txt")).write(std::string(100000, 'x')); }
  EXPECT_EQ(entries(), 0);
}

TEST_F(OutputFileTest, keeps_the_old_file_until_committed) {
  put(in_folder("a.txt"), "old");
  { OutputFile(in_folder("a.txt")).write("new"); }
  EXPECT_EQ(contents(in_folder("a.txt")), "old");
  OutputFile file(in_folder("a.txt"));
  file.write("new");
  EXPECT_EQ(contents(in_folder("a.txt")), "old");
  file.commit();
  EXPECT_EQ(contents(in_folder("a.txt")), "new");
  EXPECT_EQ(entries(), 1);
}

/// Before, across and behind what has left the buffer; by a text that is kept beside it.
TEST_F(OutputFileTest, can_be_overwritten_anywhere) {
  for (const bool scratch : {false, true}) {
    std::optional<OutputFile> file;
    scratch ? file.emplace(OutputFile::Scratch{}) : file.emplace(in_folder("a.txt"));
    EXPECT_TRUE(file->revisable());
    std::string expected;
    for (int k = 0; k < 3000; ++k) {
      const std::string piece(static_cast<std::size_t>(100 + k % 7), static_cast<char>('a' + k % 26));
      file->write(piece);
      expected += piece;
      ASSERT_EQ(file->size(), expected.size());
      const std::size_t position = expected.size() * static_cast<std::size_t>(k % 11) / 11;
      file->overwrite(position, "OVER");
      expected.replace(position, 4, "OVER");
      if (k % 100 == 0) {
        file->overwrite(0, std::string(expected.size(), '.'));
        expected.assign(expected.size(), '.');
      }
    }
    std::string copy;
    file->copy_to([&](std::string_view bytes) { copy += bytes; });
    EXPECT_EQ(copy, expected);
    if (scratch) continue;
    file->commit();
    EXPECT_EQ(contents(in_folder("a.txt")), expected);
  }
  EXPECT_EQ(entries(), 1);
}

TEST_F(OutputFileTest, a_pipe_cannot_be_overwritten) { EXPECT_FALSE(OutputFile("/dev/null").revisable()); }

TEST_F(OutputFileTest, published_parts_are_there_before_the_commit_and_stay_without_it) {
  for (const bool replaces : {false, true}) {
    const auto name = in_folder(replaces ? "old.txt" : "new.txt");
    if (replaces) put(name, "old");
    {
      OutputFile file(name);
      file.write("one\n");
      EXPECT_EQ(std::filesystem::exists(name), replaces);
      file.publish();
      EXPECT_EQ(contents(name), "one\n");
      file.write("two\n");
      EXPECT_EQ(contents(name), "one\n");
      file.publish();
      EXPECT_EQ(contents(name), "one\ntwo\n");
      file.write("three\n");
    }
    EXPECT_EQ(contents(name), "one\ntwo\n");
  }
  EXPECT_EQ(entries(), 2);
}

TEST_F(OutputFileTest, replaced_file_keeps_its_permissions) {
  put(in_folder("a.txt"), "old");
  std::filesystem::permissions(in_folder("a.txt"), std::filesystem::perms(0640));
  OutputFile(in_folder("a.txt")).commit();
  EXPECT_EQ(std::filesystem::status(in_folder("a.txt")).permissions(), std::filesystem::perms(0640));
}

TEST_F(OutputFileTest, new_file_obeys_the_umask) {
  const mode_t before = umask(027);
  OutputFile(in_folder("a.txt")).commit();
  umask(before);
  EXPECT_EQ(std::filesystem::status(in_folder("a.txt")).permissions(), std::filesystem::perms(0640));
}

TEST_F(OutputFileTest, follows_a_symbolic_link) {
  put(in_folder("real"), "old");
  std::filesystem::create_symlink("real", in_folder("link"));
  OutputFile file(in_folder("link"));
  file.write("new");
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(in_folder("link")));
  EXPECT_EQ(contents(in_folder("real")), "new");
}

TEST_F(OutputFileTest, follows_a_symbolic_link_to_a_file_to_come) {
  std::filesystem::create_directory(in_folder("sub"));
  std::filesystem::create_symlink("sub/real", in_folder("link"));
  std::filesystem::create_symlink(in_folder("link"), in_folder("link_to_link"));
  OutputFile(in_folder("link_to_link")).commit();
  EXPECT_TRUE(std::filesystem::is_symlink(in_folder("link")));
  EXPECT_TRUE(std::filesystem::is_symlink(in_folder("link_to_link")));
  EXPECT_TRUE(std::filesystem::is_regular_file(in_folder("sub/real")));
}

TEST_F(OutputFileTest, links_in_a_circle_are_an_error) {
  std::filesystem::create_symlink("b", in_folder("a"));
  std::filesystem::create_symlink("a", in_folder("b"));
  EXPECT_EQ(message_of<RunError>([&] { OutputFile file(in_folder("a")); }),
            in_folder("a").string() + ": cannot write: Too many levels of symbolic links");
}

/// A descriptor of this process, open on `file` with `flags`.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& file, int flags) : number_(open(file.c_str(), flags | O_CREAT, 0600)) {}
  ~Descriptor() { close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write(const std::string& text) const {
    ASSERT_EQ(::write(number_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  int number() const { return number_; }

 private:
  int number_;
};

TEST_F(OutputFileTest, a_descriptor_is_written_behind_what_it_has_written) {
  for (const char* folder : {"/dev/fd/", "/proc/self/fd/", "/proc/thread-self/fd/"}) {
    put(in_folder("log"), "old\n");
    const Descriptor descriptor(in_folder("log"), O_WRONLY | O_TRUNC);
    descriptor.write("before\n");
    OutputFile file(folder + std::to_string(descriptor.number()));
    file.write("output\n");
    file.commit();
    descriptor.write("after\n");
    EXPECT_EQ(contents(in_folder("log")), "before\noutput\nafter\n") << folder;
  }
  EXPECT_EQ(entries(), 1);
}

TEST_F(OutputFileTest, a_descriptor_that_appends_appends) {
  put(in_folder("log"), "old\n");
  const Descriptor descriptor(in_folder("log"), O_WRONLY | O_APPEND);
  std::filesystem::create_symlink("/dev/fd/" + std::to_string(descriptor.number()), in_folder("link"));
  OutputFile file(in_folder("link"));
  file.write("new\n");
  file.commit();
  EXPECT_EQ(contents(in_folder("log")), "old\nnew\n");
}

TEST_F(OutputFileTest, a_descriptor_that_cannot_be_written_is_known_at_once) {
  const Descriptor descriptor(in_folder("log"), O_RDONLY);
  for (const int number : {descriptor.number(), 987}) {
    const std::string name = "/dev/fd/" + std::to_string(number);
    EXPECT_EQ(message_of<RunError>([&] { OutputFile file(name); }), name + ": cannot write: Bad file descriptor");
  }
}

/// What the program opened itself, for another output, is nobody's stream.
TEST_F(OutputFileTest, a_descriptor_of_its_own_is_none_to_write_to) {
  const Descriptor own(in_folder("other"), O_WRONLY | O_CLOEXEC);
  const std::string name = "/dev/fd/" + std::to_string(own.number());
  EXPECT_EQ(message_of<RunError>([&] { OutputFile file(name); }), name + ": cannot write: Bad file descriptor");
}

TEST_F(OutputFileTest, several_in_one_folder_do_not_disturb_each_other) {
  OutputFile first(in_folder("1"));
  OutputFile second(in_folder("2"));
  first.write("first");
  second.write("second");
  first.commit();
  second.commit();
  EXPECT_EQ(contents(in_folder("1")), "first");
  EXPECT_EQ(contents(in_folder("2")), "second");
}

TEST_F(OutputFileTest, missing_folder_is_known_at_once) {
  const std::filesystem::path path = in_folder("none") / "a.txt";
  EXPECT_EQ(message_of<RunError>([&] { OutputFile file(path); }),
            path.string() + ": cannot write: No such file or directory");
}

TEST_F(OutputFileTest, folder_is_not_a_file) {
  EXPECT_EQ(message_of<RunError>([&] { OutputFile file(folder_); }),
            folder_.string() + ": cannot write: Is a directory");
  EXPECT_EQ(message_of<RunError>([&] { OutputFile file(in_folder("none") / ""); }),
            (in_folder("none") / "").string() + ": cannot write: Is a directory");
  EXPECT_EQ(message_of<RunError>([] { OutputFile file(""); }), ": cannot write: No such file or directory");
}

TEST_F(OutputFileTest, unwritable_folder_and_file_are_known_at_once) {
  EXPECT_THROW(OutputFile("/proc/a.txt"), RunError);
  if (geteuid() == 0) return;  // the superuser may write the rest
  put(in_folder("a.txt"), "old");
  std::filesystem::permissions(in_folder("a.txt"), std::filesystem::perms(0444));
  EXPECT_THROW(OutputFile(in_folder("a.txt")), RunError);
  std::filesystem::permissions(folder_, std::filesystem::perms(0555));
  EXPECT_THROW(OutputFile(in_folder("b.txt")), RunError);
  std::filesystem::permissions(folder_, std::filesystem::perms(0755));
}

TEST(OutputFile, devices_are_written_directly) {
  OutputFile file("/dev/null");
  file.write("gone");
  file.commit();
  struct stat status {};
  ASSERT_EQ(stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(OutputFile, full_device_is_an_error) {
  OutputFile file("/dev/full");
  file.write("x");
  EXPECT_EQ(message_of<RunError>([&] { file.commit(); }), "/dev/full: cannot write: No space left on device");
}

}  // namespace
}  // namespace pyrasim
