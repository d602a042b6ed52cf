#include "gui/window_watch.h"

#include <xcb/xcb.h>
#include <xcb/xcbext.h>

#include <QElapsedTimer>
#include <QGuiApplication>
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace frontier_pilot::gui {
namespace {

constexpr int kLookPeriod = 50;              // [ms]; an answer of the server is read one period later
constexpr std::uint32_t kMostStates = 1024;  // of the list that a window manager keeps of a window

template <class T>
std::unique_ptr<T, decltype(&std::free)> owned(T* reply) {
  return {reply, &std::free};
}

}  // namespace

/// A connection of its own to the X server: Qt's headers do not give access to the one that Qt uses.
class WindowWatch::Server {
 public:
  Server() : connection_(xcb_connect(nullptr, nullptr), &xcb_disconnect) {
    if (lost()) return;
    const auto state = intern("_NET_WM_STATE"), hidden = intern("_NET_WM_STATE_HIDDEN");
    state_ = atomOf(state);
    hidden_ = atomOf(hidden);
  }

  /// Whether its answer to a question is late; it may say then that the window is seen when it has long been hidden.
  bool isSilent(Duration patience) const { return asked_ && since_asked_.nsecsElapsed() > patience.count(); }
  bool lost() const { return xcb_connection_has_error(connection_.get()) != 0; }

  /// Asks the server, or reads the answer to what the call before has asked; false while there is none.
  bool isHidden(xcb_window_t window) {
    if (!asked_) {
      asked_ = Question{xcb_get_window_attributes(connection_.get(), window),
                        xcb_get_property(connection_.get(), 0, window, state_, XCB_ATOM_ATOM, 0, kMostStates)};
      xcb_flush(connection_.get());
      since_asked_.start();
      return false;
    }
    void* answer = nullptr;
    xcb_generic_error_t* error = nullptr;
    if (xcb_poll_for_reply(connection_.get(), asked_->state.sequence, &answer, &error) == 0) return false;
    const auto refused = owned(error);
    const auto state = owned(static_cast<xcb_get_property_reply_t*>(answer));
    // The server answers in order, so that this answer is there already.
    const auto attributes = owned(xcb_get_window_attributes_reply(connection_.get(), asked_->attributes, nullptr));
    asked_.reset();
    return (attributes && attributes->map_state != XCB_MAP_STATE_VIEWABLE) || (state && isInList(*state, hidden_));
  }

 private:
  struct Question {
    xcb_get_window_attributes_cookie_t attributes;
    xcb_get_property_cookie_t state;
  };

  xcb_intern_atom_cookie_t intern(const char* name) {
    return xcb_intern_atom(connection_.get(), 0, static_cast<std::uint16_t>(std::strlen(name)), name);
  }
  xcb_atom_t atomOf(xcb_intern_atom_cookie_t cookie) {
    const auto reply = owned(xcb_intern_atom_reply(connection_.get(), cookie, nullptr));
    return reply ? reply->atom : xcb_atom_t{XCB_ATOM_NONE};
  }
  static bool isInList(const xcb_get_property_reply_t& list, xcb_atom_t atom) {
    if (list.format != 32) return false;
    const auto* first = static_cast<const xcb_atom_t*>(xcb_get_property_value(&list));
    return std::find(first, first + list.value_len, atom) != first + list.value_len;
  }

  std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)> connection_;
  xcb_atom_t state_ = XCB_ATOM_NONE, hidden_ = XCB_ATOM_NONE;
  std::optional<Question> asked_;
  QElapsedTimer since_asked_;
};

WindowWatch::WindowWatch(QWidget& content, Duration patience)
    : QObject(&content), content_(content), patience_(patience) {
  if (QGuiApplication::platformName() != "xcb") return;
  server_ = std::make_unique<Server>();
  if (server_->lost()) return;
  connect(&timer_, &QTimer::timeout, this, &WindowWatch::look);
  timer_.start(kLookPeriod);
}

WindowWatch::~WindowWatch() = default;

void WindowWatch::look() {
  const WId window = content_.window()->internalWinId();
  if (window == 0) return;
  if (server_->lost() || server_->isHidden(static_cast<xcb_window_t>(window)) || server_->isSilent(patience_)) {
    emit cannotBeSeen();
  }
}

}  // namespace frontier_pilot::gui
