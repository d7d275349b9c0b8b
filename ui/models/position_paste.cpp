// A position as somebody else's program wrote it.

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/geo/geodesy.h"
#include "core/geo/utm.h"
#include "ui/models/figures.h"

namespace leadline::ui {
namespace {

/// A number or a letter of the compass.
struct Token {
  char letter = 0;  // 0: a number
  double value = 0.0;
  bool sign = false, decimals = false, negative = false;
};

Error unreadable(const std::string& why) {
  return {"this is no position: " + why, "", "write it like 36°54.60000′ N 129°54.30000′ E"};
}

/// Degree, minute and second signs and every kind of blank become blanks, every minus '-'.
std::string plain(std::string_view text) {
  static constexpr std::pair<const char*, char> kMarks[] = {
      {"\u00b0", ' '}, {"\u00ba", ' '}, {"\u2032", ' '}, {"\u2033", ' '}, {"\u2019", ' '},
      {"\u2018", ' '}, {"\u201d", ' '}, {"\u201c", ' '}, {"\u00b4", ' '}, {"\u00a0", ' '},
      {"\u2009", ' '}, {"\u202f", ' '}, {"\u2212", '-'}, {"\u2013", '-'}, {"\u00b7", ' '}};
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    bool found = false;
    for (const auto& [mark, c] : kMarks) {
      const std::string_view m(mark);
      if (text.substr(i, m.size()) != m) continue;
      out += c, i += m.size(), found = true;
      break;
    }
    if (!found) out += text[i++];
  }
  return out;
}

Result<std::vector<Token>> tokens_of(const std::string& text, bool& tight_comma) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const auto digit = [&](std::size_t k) {
      return k < text.size() && std::isdigit(static_cast<unsigned char>(text[k])) != 0;
    };
    if (std::isspace(c) != 0 || c == '\'' || c == '"' || c == ';' || c == '/' || c == ':') {
      ++i;
    } else if (c == ',') {
      if (i > 0 && digit(i - 1) && digit(i + 1)) tight_comma = true;
      ++i;
    } else if (digit(i) || ((c == '-' || c == '+' || c == '.') &&
                            (digit(i + 1) || text[i + 1 < text.size() ? i + 1 : i] == '.'))) {
      // "36-54.6": a dash right behind a digit divides, it is no sign.
      const bool divides = c == '-' && i > 0 && digit(i - 1);
      Token token;
      token.sign = !divides && (c == '-' || c == '+');
      token.negative = token.sign && c == '-';
      if (c == '-' || c == '+') ++i;
      std::string number;
      while (digit(i) || (i < text.size() && text[i] == '.')) number += text[i++];
      char* end = nullptr;
      token.value = std::strtod(number.c_str(), &end);
      token.decimals = number.find('.') != std::string::npos;
      if (*end != 0 || number == "." || number.size() > 18)
        return unreadable("\"" + number + "\" is no number");
      tokens.push_back(token);
    } else if (std::isalpha(c) != 0) {
      const bool word = i + 1 < text.size() && std::isalpha(static_cast<unsigned char>(text[i + 1])) != 0;
      if (word) return unreadable("it holds words");
      const char letter = static_cast<char>(std::toupper(c));
      if (letter != 'M' && letter != 'D') tokens.push_back({letter, 0.0, false, false, false});
      ++i;
    } else {
      return unreadable(std::string("\"") + text[i] + "\" does not belong to one");
    }
  }
  return tokens;
}

/// Degrees of one to three numbers.
Result<double> degrees_of(const std::vector<Token>& numbers, char letter, double most) {
  if (numbers.empty() || numbers.size() > 3) return unreadable("latitude or longitude is missing");
  double deg = 0.0, unit = 1.0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && numbers[i].sign) return unreadable("a sign stands in its middle");
    if (i + 1 < numbers.size() && numbers[i].decimals)
      return unreadable("only the last number may have decimals");
    if (i > 0 && numbers[i].value >= 60.0) return unreadable("minutes and seconds end at 60");
    deg += numbers[i].value * unit;
    unit /= 60.0;
  }
  if (deg > most) return unreadable(most > 90.0 ? "longitudes end at 180°" : "latitudes end at 90°");
  if (letter != 0 && numbers[0].sign) return unreadable("it has a sign and a letter");
  const bool negative = letter == 'S' || letter == 'W' || numbers[0].negative;
  return negative ? -deg : deg;
}

Result<Geodetic> place(double lat_deg, double lon_deg) {
  return Geodetic{Angle::deg(lat_deg), geo::normal_longitude(Angle::deg(lon_deg))};
}

/// "52N 402345.67 E 4085123.45 N" and "52 N 402345.67 4085123.45".
std::optional<Result<Geodetic>> utm_of(const std::vector<Token>& tokens) {
  std::vector<Token> numbers;
  for (const Token& token : tokens)
    if (token.letter == 0) numbers.push_back(token);
  if (numbers.size() != 3 || tokens.size() < 4 || tokens[1].letter == 0 || numbers[1].value < 1000.0)
    return std::nullopt;
  const char band = tokens[1].letter;
  if (numbers[0].decimals || numbers[0].sign || band < 'C' || band > 'X' || band == 'I' || band == 'O' ||
      band == 'E' || band == 'W')
    return unreadable("a UTM zone is a number and N or S");
  for (std::size_t i = 2; i < tokens.size(); ++i)
    if (tokens[i].letter != 0 && tokens[i].letter != 'E' && tokens[i].letter != 'N')
      return unreadable("a UTM position is zone, easting, northing");
  // N and S are the hemisphere, as this program writes it; other letters are bands of latitude.
  const bool north = band == 'N' || (band != 'S' && band > 'N');
  auto point = geo::from_utm(static_cast<int>(numbers[0].value), north, numbers[1].value, numbers[2].value);
  if (!point) return unreadable(point.error().what);
  return Result<Geodetic>(point.value());
}

Result<Geodetic> lettered(const std::vector<Token>& tokens) {
  std::vector<Token> numbers[2];
  char letters[2] = {0, 0};
  const bool before = tokens.front().letter != 0;
  std::size_t part = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].letter == 0) {
      if (part > 1) return unreadable("there are three parts to it");
      numbers[part].push_back(tokens[i]);
      continue;
    }
    if (before && i > 0) ++part;
    if (part > 1 || letters[part] != 0) return unreadable("it has too many letters");
    letters[part] = tokens[i].letter;
    if (!before) ++part;
  }
  const auto is_lat = [](char c) { return c == 'N' || c == 'S'; };
  const auto is_lon = [](char c) { return c == 'E' || c == 'W'; };
  const bool lat_first = is_lat(letters[0]) && is_lon(letters[1]);
  if (!lat_first && !(is_lon(letters[0]) && is_lat(letters[1])))
    return unreadable("it needs one of N, S and one of E, W");
  const std::size_t lat = lat_first ? 0 : 1, lon = 1 - lat;
  const auto lat_deg = degrees_of(numbers[lat], letters[lat], 90.0);
  if (!lat_deg) return lat_deg.error();
  const auto lon_deg = degrees_of(numbers[lon], letters[lon], 180.0);
  if (!lon_deg) return lon_deg.error();
  return place(lat_deg.value(), lon_deg.value());
}

}  // namespace

Result<Geodetic> parse_position(std::string_view text) {
  if (text.size() > 200) return unreadable("it is too long");
  bool tight_comma = false;
  const auto found = tokens_of(plain(text), tight_comma);
  if (!found) return found.error();
  const auto& tokens = found.value();
  if (tokens.empty()) return unreadable("it is empty");
  if (auto utm = utm_of(tokens)) return *utm;
  std::size_t letters = 0;
  for (const Token& token : tokens) letters += token.letter != 0 ? 1 : 0;
  const std::size_t count = tokens.size() - letters;
  // "36,91 129,90" must not become 36 degrees 91 minutes.
  if (tight_comma && count > 2) return unreadable("write decimals with a point");
  if (letters > 0) return lettered(tokens);
  if (count != 2 && count != 4 && count != 6) return unreadable("it needs a latitude and a longitude");
  const auto half = static_cast<std::ptrdiff_t>(count / 2);
  const auto lat_deg = degrees_of({tokens.begin(), tokens.begin() + half}, 0, 90.0);
  if (!lat_deg) return lat_deg.error();
  const auto lon_deg = degrees_of({tokens.begin() + half, tokens.end()}, 0, 180.0);
  if (!lon_deg) return lon_deg.error();
  return place(lat_deg.value(), lon_deg.value());
}

}  // namespace leadline::ui
