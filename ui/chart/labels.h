#pragma once

#include <QLineF>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <map>
#include <string>
#include <vector>

#include "ui/look/colours.h"

namespace leadline::ui {

/// What stands beside a symbol: its name, bold in the object's colour, and a line of figures in ink.
struct Label {
  std::string key;         ///< of the object, the same in every frame
  QPointF at;              ///< the symbol's position on the screen
  double clear_px = 16.0;  ///< of the symbol: the label starts outside
  QString name;
  Role role = Role::ink;
  QString detail;  ///< may be empty
};

struct PlacedLabel {
  Label label;
  QRectF box;
  bool at_left = false;  ///< of the symbol: its lines end at the right
  QLineF leader;         ///< null beside the symbol
};

/// What labels keep clear of.
struct LabelObstacles {
  std::vector<QRectF> boxes;  ///< furniture, other text
  std::vector<QLineF> lines;  ///< heading lines, course vectors
};

/// Where each label stood last: what makes them stand still. A value, kept between frames by the chart.
struct LabelPlaces {
  std::map<std::string, int> place;  ///< key to the number of the place
};

/// Places every label whose symbol is on the chart, the first ones first. Tried in turn: right below, right
/// above, left below, left above, then further off with a leader. A label keeps its place while that is free;
/// one with a leader comes back when a place beside the symbol is free by 6 px. Boxes never overlap one
/// another, the obstacles or a symbol unless the chart has no room at all. About 20 us a label.
[[nodiscard]] std::vector<PlacedLabel> place_labels(LabelPlaces& places, const std::vector<Label>& labels,
                                                    const LabelObstacles& obstacles, QRectF chart);
void draw_label(QPainter& painter, const PlacedLabel& label, const Colours& colours);

}  // namespace leadline::ui
