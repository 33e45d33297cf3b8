// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The debug messages of the extension, as a callback gets them.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "conformance/suite/test.h"

namespace glark::conformance {

struct Message {
  GLenum source = 0;
  GLenum type = 0;
  GLuint id = 0;
  GLenum severity = 0;
  std::string text;
};
using Messages = std::vector<Message>;

inline void GLAD_API_PTR note(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                              const GLchar* text, const void* user) {
  if (source != GL_DEBUG_SOURCE_THIRD_PARTY) return;  // of the driver
  auto* const messages = static_cast<Messages*>(const_cast<void*>(user));
  messages->push_back({source, type, id, severity, std::string(text, static_cast<std::size_t>(length))});
}

// The messages that arrive while it lives, in the context that is current when it is made.
class Listener {
 public:
  Listener() {
    gl.Enable(GL_DEBUG_OUTPUT);
    gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl.DebugMessageCallback(note, &messages_);
  }
  ~Listener() { gl.DebugMessageCallback(nullptr, nullptr); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  Messages take_all() { return std::exchange(messages_, {}); }
  // The messages with this id since the last call; the others are dropped.
  Messages take(GLuint id) {
    Messages found;
    std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(found),
                 [id](const Message& message) { return message.id == id; });
    messages_.clear();
    return found;
  }

 private:
  Messages messages_;
};

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Expects one message, with the type and the severity of an error or of another message.
inline void expect_message(Test& t, const Messages& messages, bool is_error, const std::string& what = "") {
  const std::string head = what.empty() ? what : what + ": ";
  t.require(messages.size() == 1, head + "one message, there are " + as_text(messages.size()));
  const Message& message = messages.front();
  t.expect_equal(message.source, GLenum{GL_DEBUG_SOURCE_THIRD_PARTY}, head + "the source");
  const GLenum type = is_error ? GL_DEBUG_TYPE_ERROR : GL_DEBUG_TYPE_OTHER;
  const GLenum severity = is_error ? GL_DEBUG_SEVERITY_HIGH : GL_DEBUG_SEVERITY_MEDIUM;
  t.expect_equal(message.type, type, head + "the type");
  t.expect_equal(message.severity, severity, head + "the severity");
}

}  // namespace glark::conformance
