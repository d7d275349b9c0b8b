#include "core/decode/json_reader.h"

namespace leadline::decode {
namespace {

bool is_hex(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

}  // namespace

bool JsonReader::fail() {
  failed_ = true;
  return false;
}

void JsonReader::blanks() {
  while (p_ != end_ && (*p_ == ' ' || *p_ == '\t' || *p_ == '\n' || *p_ == '\r')) ++p_;
}

bool JsonReader::next(JsonEvent& event) {
  if (failed_) return false;
  blanks();
  event = {};
  if (depth_ == 0) {
    if (!done_) {
      done_ = true;
      return value(event);
    }
    return p_ == end_ ? false : fail();
  }
  if (p_ == end_) return fail();
  const bool object = is_object_[static_cast<std::size_t>(depth_ - 1)];
  if (*p_ == (object ? '}' : ']')) return close(event);
  if (begun_) {
    if (*p_ != ',') return fail();
    ++p_;
    blanks();
  }
  begun_ = true;
  if (object) {
    if (p_ == end_ || *p_ != '"' || !text(event.key)) return fail();
    blanks();
    if (p_ == end_ || *p_ != ':') return fail();
    ++p_;
    blanks();
  }
  return value(event);
}

bool JsonReader::close(JsonEvent& event) {
  ++p_;
  --depth_;
  event.kind =
      is_object_[static_cast<std::size_t>(depth_)] ? JsonEvent::Kind::object_end : JsonEvent::Kind::list_end;
  event.depth = depth_;
  begun_ = true;
  return true;
}

bool JsonReader::value(JsonEvent& event) {
  using Kind = JsonEvent::Kind;
  if (p_ == end_) return fail();
  event.depth = depth_;
  switch (*p_) {
    case '{':
    case '[':
      if (depth_ == kDeepest) return fail();
      event.kind = *p_ == '{' ? Kind::object : Kind::list;
      is_object_[static_cast<std::size_t>(depth_++)] = *p_ == '{';
      begun_ = false;
      ++p_;
      return true;
    case '"':
      event.kind = Kind::text;
      return text(event.value) || fail();
    case 't':
      event.kind = Kind::boolean;
      event.value = "true";
      return word("true");
    case 'f':
      event.kind = Kind::boolean;
      event.value = "false";
      return word("false");
    case 'n':
      return word("null");
    default:
      break;
  }
  const char* const first = p_;
  while (p_ != end_ &&
         ((*p_ >= '0' && *p_ <= '9') || *p_ == '-' || *p_ == '+' || *p_ == '.' || *p_ == 'e' || *p_ == 'E'))
    ++p_;
  if (p_ == first) return fail();
  event.kind = Kind::number;
  event.value = std::string_view(first, static_cast<std::size_t>(p_ - first));
  return true;
}

bool JsonReader::word(std::string_view expected) {
  if (std::string_view(p_, static_cast<std::size_t>(end_ - p_)).substr(0, expected.size()) != expected)
    return fail();
  p_ += expected.size();
  return true;
}

bool JsonReader::text(std::string_view& into) {
  const char* const first = ++p_;
  for (; p_ != end_ && *p_ != '"'; ++p_) {
    if (static_cast<unsigned char>(*p_) < 0x20) return false;
    if (*p_ != '\\') continue;
    if (++p_ == end_) return false;
    if (*p_ == 'u') {
      for (int i = 0; i < 4; ++i)
        if (++p_ == end_ || !is_hex(*p_)) return false;
    } else if (std::string_view("\"\\/bfnrt").find(*p_) == std::string_view::npos) {
      return false;
    }
  }
  if (p_ == end_) return false;
  into = std::string_view(first, static_cast<std::size_t>(p_ - first));
  ++p_;
  return true;
}

}  // namespace leadline::decode
