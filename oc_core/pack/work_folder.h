// The folder `OUTPUT.work` beside a packed scene that is being made: what an ended job leaves, and the next one goes on
// with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace ocelli {

/// Locked while it lives: of several jobs that write the same output one goes on, whatever program runs them. The
/// system lets go of the lock when its process ends, however it ends.
class WorkFolder {
 public:
  /// Keeps what a job with the same `sourceKey` left, and removes what others left; an empty key keeps nothing. Throws
  /// WorkError where another job has it, the output cannot be written, or something that is no such folder is there.
  WorkFolder(const std::filesystem::path& output, const std::string& sourceKey);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  std::filesystem::path triangles() const { return folder_ / "triangles"; }
  std::filesystem::path places() const { return folder_ / "places"; }
  std::filesystem::path part(uint32_t index) const;
  /// With all that is in it.
  void remove() const;

 private:
  void takeLock(const std::filesystem::path& output);
  void prepare(const std::filesystem::path& output, const std::string& sourceKey) const;
  void removeContents() const;

  std::filesystem::path folder_;
  std::filesystem::path lockFile_;
  int lock_ = -1;
  bool isNew_ = false;
};

}  // namespace ocelli
