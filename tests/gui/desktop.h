#pragma once
// A display with a window manager that nobody sees, and a hand on it.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/media/process.h"

namespace morphkit::test {

/// Asks again and again until `condition` holds. @return false after a minute.
bool holds_at_last(const std::function<bool()>& condition);

/// Xvfb and openbox; DISPLAY of this process names it while it lives.
class Desktop {
 public:
  /// @throws std::runtime_error if they do not start.
  Desktop();
  ~Desktop();

  /// Waits for a window with these words in its title and takes the keyboard there. @throws std::runtime_error.
  void use_window(const std::string& title);
  /// Whether there is one now.
  bool has_window(const std::string& title) const;

  // Positions are px of the window that is used.
  void move(cv::Point to);
  void drag(cv::Point from, cv::Point to);
  void wheel(cv::Point at, int notches);  ///< positive: away from the hand
  void press(const std::string& key);     ///< a keysym: "s", "space", "Escape"
  void close_window();                    ///< as its title bar's cross does

  void screenshot(const std::filesystem::path& file) const;

 private:
  void xdotool(const std::vector<std::string>& words) const;

  std::unique_ptr<media::Process> server_, manager_;
  std::string window_;
};

}  // namespace morphkit::test
