#include "ui/models/timeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace leadline::ui {
namespace {

Time at(double s) { return Time{1'790'000'000'000'000'000} + duration(s); }

History base() {
  History h;
  h.first = at(0.0), h.last = at(1000.0);
  h.tracks.push_back({0, "fusion", Body::vehicle, {}});
  return h;
}

TEST(Timeline, AvailabilityReachesToTheNextChangeAndTheEnd) {
  History h = base();
  h.modes = {{at(10), Mode::C, ""}, {at(100), Mode::B, ""}, {at(300), Mode::E1, ""}};
  TimelineModel model;
  model.update(h, 0);
  const auto& a = model.data().availability;
  ASSERT_EQ(a.size(), 3U);
  EXPECT_EQ(a[0].span, (TimeSpan{at(10), at(100)}));
  EXPECT_EQ(a[2].span, (TimeSpan{at(300), at(1000)}));
  h.last = at(1500.0);
  h.modes.push_back({at(1200), Mode::A, ""});
  model.update(h, 0);
  EXPECT_EQ(a[2].span, (TimeSpan{at(300), at(1200)}));
  EXPECT_EQ(a[3].span.until, at(1500));
  EXPECT_EQ(model.data().run, (TimeSpan{at(0), at(1500)}));
}

TEST(Timeline, EventsAlertsAndGapsAreInOrderHoweverTheyCome) {
  History h = base();
  h.events = {{at(50), at(50), EventMark::Kind::warning, "w"},
              {at(20), at(20), EventMark::Kind::alarm, "a"},
              {at(60), at(90), EventMark::Kind::gap, "nothing heard for 30 s"},
              {at(30), at(30), EventMark::Kind::event, "position set anew from 5 fixes of usbl that agree"}};
  TimelineModel model;
  model.update(h, 0);
  ASSERT_EQ(model.data().alerts.size(), 2U);
  EXPECT_EQ(model.data().alerts[0].text, "a");
  EXPECT_EQ(model.data().alerts[0].priority, Alarm::Priority::alarm);
  EXPECT_EQ(model.data().gaps[0].span, (TimeSpan{at(60), at(90)}));
  EXPECT_EQ(model.data().events[0].text, "position set anew from 5…");
}

TEST(Timeline, SigmaKeepsTheGreatestOfEachColumnAndStaysBounded) {
  History h = base();
  h.last = at(86'400.0);
  auto& points = h.tracks[0].points;
  TimelineModel model;
  for (int i = 0; i < 864'000; ++i) {
    points.push_back(
        {at(i * 0.1), {}, i == 500'003 ? 99.0F : 1.0F + 0.5F * static_cast<float>(std::sin(i * 1e-4))});
    if (i % 100'000 == 0) model.update(h, 0);
  }
  model.update(h, 0);
  EXPECT_LE(model.data().sigma.size(), 4097U);
  EXPECT_GE(model.data().sigma.size(), 1500U);
  const auto& sigma = model.data().sigma;
  for (std::size_t i = 1; i < sigma.size(); ++i) ASSERT_LT(sigma[i - 1].at, sigma[i].at);
  const auto shown = model.sigma({at(0), at(86'400)}, 1000);
  EXPECT_LE(shown.size(), 1000U);
  EXPECT_GE(shown.size(), 990U);
  const auto worst = std::max_element(shown.begin(), shown.end(),
                                      [](const auto& a, const auto& b) { return a.drms_m < b.drms_m; });
  EXPECT_EQ(worst->drms_m, 99.0);
  EXPECT_EQ(worst->at, at(50'000.3)) << "a spike of one sample is seen";
  EXPECT_TRUE(model.sigma({at(5), at(5)}, 10).empty());
  EXPECT_TRUE(model.sigma({at(0), at(5)}, 0).empty());
}

TEST(Timeline, AnotherHistoryBeginsAnew) {
  History h = base();
  h.modes = {{at(10), Mode::C, ""}};
  TimelineModel model;
  model.update(h, 0);
  History other = base();
  other.first = at(5000.0), other.last = at(6000.0);
  other.modes = {{at(5000), Mode::A, ""}};
  model.update(other, 0);
  ASSERT_EQ(model.data().availability.size(), 1U);
  EXPECT_EQ(model.data().availability[0].mode, Mode::A);
  model.update(History{}, 0);
  EXPECT_TRUE(model.data().availability.empty());
}

TEST(Timeline, ShortWordsEndAtASignOrAWholeLetter) {
  EXPECT_EQ(short_words("bottom lock"), "bottom lock");
  EXPECT_EQ(short_words("GNSS lost: no fix for 31 s"), "GNSS lost");
  EXPECT_EQ(short_words("ååååååååååååååååååååååå").substr(24), "…");
  EXPECT_EQ(short_words(""), "");
}

}  // namespace
}  // namespace leadline::ui
