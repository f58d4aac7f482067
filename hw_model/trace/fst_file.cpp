// SPDX-License-Identifier: Apache-2.0
#include "hw_model/trace/fst_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fstapi.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "error.h"
#include "hw_model/trace/trace_writer.h"
#include "version.h"

namespace pyrasim::hw {
namespace {

constexpr std::uint64_t block_changes = 1'000'000;  ///< that the writer holds in memory, several bytes each

}  // namespace

/// The writer wants a name. Its files lose theirs as soon as they are open, so that nothing is left of them however the
/// program ends.
FstFile::FstFile(const std::filesystem::path& folder, const std::string& time_unit, const std::string& comment)
    : folder_(folder) {
  std::string own = (folder / "pyrasim-XXXXXX").string();
  if (mkdtemp(own.data()) == nullptr) fail(std::generic_category().message(errno));
  const std::string name = own + "/trace";
  writer_ = fstWriterCreate(name.c_str(), 1);
  descriptor_ = open(name.c_str(), O_RDONLY | O_CLOEXEC);
  const int error = errno;
  std::error_code ignored;
  std::filesystem::remove_all(own, ignored);
  if (writer_ == nullptr || descriptor_ < 0) {
    complete();
    fail(std::generic_category().message(error));
  }
  fstWriterSetPackType(writer_, FST_WR_PT_ZLIB);
  fstWriterSetVersion(writer_, fmt::format("pyrasim {}", version()).c_str());
  fstWriterSetDate(writer_, "");  // equal runs make equal files
  fstWriterSetComment(writer_, comment.c_str());
  fstWriterSetTimescaleFromString(writer_, time_unit.c_str());
  std::array names{state_names[0].data(), state_names[1].data(), state_names[2].data(), state_names[3].data()};
  std::array values{"00", "01", "10", "11"};
  state_names_ = fstWriterCreateEnumTable(writer_, "state", names.size(), 2, names.data(), values.data());
}

FstFile::~FstFile() {
  complete();
  if (descriptor_ >= 0) close(descriptor_);
}

void FstFile::begin_scope(const std::string& name) {
  fstWriterSetScope(writer_, FST_ST_VCD_MODULE, name.c_str(), nullptr);
}

void FstFile::end_scope() { fstWriterSetUpscope(writer_); }

std::size_t FstFile::add_signal(const std::string& name, std::size_t bits, bool states) {
  if (states) fstWriterEmitEnumTableRef(writer_, state_names_);
  const std::string with_range = fmt::format("{} [{}:0]", name, bits - 1);
  const auto width = static_cast<std::uint32_t>(bits);
  const fstHandle handle = fstWriterCreateVar(writer_, FST_VT_VCD_REG, FST_VD_IMPLICIT, width, with_range.c_str(), 0);
  signals_.push_back({handle, std::string(bits, '0')});
  return signals_.size() - 1;
}

void FstFile::set_time(std::uint64_t time) { fstWriterEmitTimeChange(writer_, time); }

void FstFile::change(std::size_t signal, std::string_view bits) {
  auto& [handle, value] = signals_[signal];
  const auto missing = static_cast<std::ptrdiff_t>(value.size() - bits.size());
  const char fill = bits.front() == 'x' ? 'x' : '0';
  std::copy(bits.begin(), bits.end(), std::fill_n(value.begin(), missing, fill));
  fstWriterEmitValueChange(writer_, handle, value.c_str());
  if (++changes_ % block_changes == 0) fstWriterFlushContext(writer_);
}

void FstFile::complete() {
  if (void* const writer = std::exchange(writer_, nullptr)) fstWriterClose(writer);
}

/// The writer does not say whether the disk took what it wrote.
bool FstFile::is_whole() const {
  void* const reader = fstReaderOpen(fmt::format("/proc/self/fd/{}", descriptor_).c_str());
  if (reader == nullptr) return false;
  fstReaderSetFacProcessMaskAll(reader);
  std::uint64_t changes = 0;
  const auto count = [](void* counter, std::uint64_t, fstHandle, const unsigned char*) {
    ++*static_cast<std::uint64_t*>(counter);
  };
  const bool read = fstReaderIterBlocks(reader, count, &changes, nullptr) != 0;
  fstReaderClose(reader);
  return read && changes >= changes_;
}

void FstFile::write_to(OutputFile& output) {
  complete();
  if (!is_whole()) fail("what was written cannot be read again; is the disk full?");
  std::array<char, 65536> piece;
  off_t position = 0;
  while (const ssize_t count = pread(descriptor_, piece.data(), piece.size(), position)) {
    if (count < 0) fail(std::generic_category().message(errno));
    output.write({piece.data(), static_cast<std::size_t>(count)});
    position += count;
  }
}

void FstFile::fail(const std::string& why) const {
  throw RunError(fmt::format("{}: cannot write: {}", folder_.string(), why));
}

}  // namespace pyrasim::hw
