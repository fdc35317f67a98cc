#include <string>

#include "morph/project/project.h"

namespace morphkit::project {
namespace {

// Two pieces: compilers need not accept longer string literals than 65536 bytes, people need shorter ones.
constexpr const char* kRoot = R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "$id": "https://morphkit.invalid/schema/project-1.json",
  "title": "morphkit project, version 1",
  "description": "Two pictures, what corresponds to what, how the change is timed, and what comes out. Coordinates are pixels, x right, y down, from the top left corner of the picture; the centre of its first pixel is [0.5, 0.5].",
  "type": "object",
  "required": ["morphkit", "source", "destination"],
  "additionalProperties": false,
  "properties": {
    "morphkit": {"const": 1, "description": "Version of the file's form."},
    "source": {"$ref": "#/$defs/side", "description": "The picture to start from."},
    "destination": {"$ref": "#/$defs/side", "description": "The picture to arrive at."},
    "groups": {
      "type": "array", "maxItems": 100000, "items": {"$ref": "#/$defs/group"},
      "description": "Settings shared by features that name the group."
    },
    "features": {
      "type": "array", "maxItems": 100000, "items": {"$ref": "#/$defs/feature"},
      "description": "What corresponds to what."
    },
    "mesh": {
      "type": "object",
      "required": ["size"],
      "additionalProperties": false,
      "properties": {
        "size": {
          "type": "array", "prefixItems": [{"$ref": "#/$defs/count"}, {"$ref": "#/$defs/count"}], "minItems": 2, "maxItems": 2,
          "description": "Columns and rows: the number of vertices in a row and in a column, together at most 500000."
        },
        "source": {"$ref": "#/$defs/vertices", "description": "Where the vertices lie on the source picture."},
        "destination": {"$ref": "#/$defs/vertices", "description": "Where the same vertices lie on the destination picture."},
        "groups": {
          "type": "array", "maxItems": 100000, "items": {"$ref": "#/$defs/meshGroup"},
          "description": "Vertices that are timed with a group."
        }
      },
      "description": "A grid laid over both pictures; its vertices correspond one to one. Those at the border lie on the border of the picture."
    },
    "warp": {
      "type": "object",
      "additionalProperties": false,
      "properties": {
        "method": {"enum": ["lines", "mesh"], "description": "How space is bent. Default: mesh if there is a mesh and no feature, else lines."},
        "spline": {"enum": ["monotone", "catmull-rom", "linear"], "description": "The curves through the vertices of the mesh. Default: monotone."},
        "order": {"enum": ["auto", "rows-first", "columns-first"], "description": "The direction in which the mesh moves pixels first. Default: auto, that is the one that keeps more of the picture."},
        "a": {"$ref": "#/$defs/a"},
        "b": {"$ref": "#/$defs/b"},
        "p": {"$ref": "#/$defs/p"},
        "scale": {"$ref": "#/$defs/scale"},
        "between": {"$ref": "#/$defs/between"},
        "turns": {"$ref": "#/$defs/turns"},
        "field": {"enum": ["adaptive", "exact"], "description": "How the field of lines is evaluated: adaptive interpolates the pull of far lines, within 1/32 pixel of the exact field, which takes several times as long. Default: adaptive."},
        "filter": {"enum": ["nearest", "bilinear", "bicubic", "area", "mitchell", "lanczos"], "description": "How colours are found: at a point (the first three), or as a mean over what lies under the output pixel, so that nothing aliases where the picture shrinks. Default: area."},
        "border": {"enum": ["auto", "transparent", "clamp", "mirror"], "description": "What lies beyond the edge of a picture. Default: auto, that is clamp where the picture covers the canvas and transparent where it does not."}
      }
    },
    "transition": {
      "type": "object",
      "additionalProperties": false,
      "properties": {
        "shape": {"$ref": "#/$defs/timing", "description": "How the features move. Default: linear."},
        "dissolve": {"$ref": "#/$defs/timing", "description": "How the colours change. Default: linear."},
        "blend": {"enum": ["linear", "display"], "description": "Mix light, or display values as old tools do. Default: linear."}
      }
    },
    "output": {
      "type": "object",
      "additionalProperties": false,
      "properties": {
        "size": {
          "type": "array", "prefixItems": [{"$ref": "#/$defs/extent"}, {"$ref": "#/$defs/extent"}], "minItems": 2, "maxItems": 2,
          "description": "Width and height in pixels, together at most 2^30 pixels. Default: the size of the source picture."
        },
        "fit": {"enum": ["contain", "cover", "stretch", "none"], "description": "How pictures of another size are placed. Default: cover."},
        "frames": {"type": "integer", "minimum": 1, "maximum": 10000000, "description": "Number of frames. Default: 48."},
        "start": {"type": "integer", "minimum": 0, "maximum": 1000000000, "description": "Number of the first frame. Default: 1."},
        "fps": {
          "anyOf": [
            {"type": "integer", "minimum": 1, "maximum": 1000},
            {"enum": [23.976, 23.98, 29.97, 47.952, 59.94, 119.88]},
            {"type": "string", "pattern": "^[0-9]{1,7}(/[0-9]{1,7})?$"}
          ],
          "description": "Frames per second: 24, 29.97 (meaning 30000/1001) or a fraction such as \"30000/1001\"; terms from 1 to 1000000, at most 1000. Default: 24."
        },
        "background": {
          "anyOf": [
            {"enum": ["transparent", "black", "white"]},
            {"type": "string", "pattern": "^#([0-9a-fA-F]{6}|[0-9a-fA-F]{8})$"},
            {"type": "array", "items": {"$ref": "#/$defs/fraction"}, "minItems": 3, "maxItems": 4},
            {"type": "object", "required": ["image"], "additionalProperties": false, "properties": {"image": {"$ref": "#/$defs/name"}}}
          ],
          "description": "What lies behind: a colour as on screen (sRGB, [r, g, b] or [r, g, b, a] from 0 to 1, not premultiplied) or a picture. Default: transparent."
        }
      }
    }
  },
)json";

constexpr const char* kDefinitions = R"json(  "$defs": {
    "name": {"type": "string", "minLength": 1},
    "coordinate": {"type": "number", "minimum": -1000000, "maximum": 1000000},
    "fraction": {"type": "number", "minimum": 0, "maximum": 1},
    "count": {"type": "integer", "minimum": 2, "maximum": 1000},
    "index": {"type": "integer", "minimum": 0, "maximum": 999},
    "extent": {"type": "integer", "minimum": 1, "maximum": 65536},
    "xy": {"type": "array", "prefixItems": [{"$ref": "#/$defs/coordinate"}, {"$ref": "#/$defs/coordinate"}], "minItems": 2, "maxItems": 2},
    "ends": {"type": "array", "items": {"$ref": "#/$defs/xy"}, "minItems": 2, "maxItems": 2},
    "points": {"type": "array", "items": {"$ref": "#/$defs/xy"}, "minItems": 2, "maxItems": 100000},
    "vertices": {
      "anyOf": [
        {"enum": ["uniform"]},
        {"type": "array", "items": {"$ref": "#/$defs/xy"}, "minItems": 4, "maxItems": 500000}
      ],
      "description": "Row by row from the top left, each row from the left; or evenly spaced over the picture. Default: uniform."
    },
    "meshGroup": {
      "type": "object",
      "required": ["group", "vertices"],
      "additionalProperties": false,
      "properties": {
        "group": {"$ref": "#/$defs/name", "description": "Id of a group whose settings apply."},
        "vertices": {
          "type": "array", "maxItems": 500000,
          "items": {"type": "array", "prefixItems": [{"$ref": "#/$defs/index"}, {"$ref": "#/$defs/index"}], "minItems": 2, "maxItems": 2},
          "description": "[column, row] of each, counted from 0. A vertex is in one group at most."
        }
      }
    },
    "a": {"type": "number", "minimum": 0, "maximum": 1000000, "description": "Pixels. 0: what lies on a feature follows it exactly; more: softer. Default: 1."},
    "b": {"type": "number", "minimum": 0, "maximum": 8, "description": "How fast the pull of a feature falls with distance. Default: 2."},
    "p": {"type": "number", "minimum": 0, "maximum": 1, "description": "How much more longer features pull. Default: 0."},
    "scale": {"enum": ["along", "uniform"], "description": "Whether a line that grows stretches along itself only, or all around. Default: along."},
    "between": {"enum": ["endpoints", "centre"], "description": "Whether the ends of a line move straight, or its centre does while it turns. Default: endpoints."},
    "turns": {"type": "integer", "minimum": -1000, "maximum": 1000, "description": "Extra whole turns on the way, clockwise on screen; with between: centre. Default: 0."},
    "side": {
      "type": "object",
      "required": ["image"],
      "additionalProperties": false,
      "properties": {
        "image": {"$ref": "#/$defs/name", "description": "Path; relative ones start at the folder of this file."},
        "colorspace": {"enum": ["srgb", "linear"], "description": "What the values in the picture mean. Default: what the picture says of itself."}
      }
    },
    "influence": {
      "type": "object",
      "additionalProperties": false,
      "properties": {
        "a": {"$ref": "#/$defs/a"},
        "b": {"$ref": "#/$defs/b"},
        "p": {"$ref": "#/$defs/p"},
        "scale": {"$ref": "#/$defs/scale"},
        "between": {"$ref": "#/$defs/between"},
        "turns": {"$ref": "#/$defs/turns"}
      },
      "description": "As in the warp of the project, for this feature or group only."
    },
    "progress": {
      "type": "object",
      "additionalProperties": false,
      "properties": {"shape": {"$ref": "#/$defs/timing"}, "dissolve": {"$ref": "#/$defs/timing"}},
      "description": "As in the transition of the project, for this feature or group only."
    },
    "group": {
      "type": "object",
      "required": ["id"],
      "additionalProperties": false,
      "properties": {
        "id": {"$ref": "#/$defs/name", "description": "Unique among the groups."},
        "warp": {"$ref": "#/$defs/influence"},
        "transition": {"$ref": "#/$defs/progress"}
      }
    },
    "feature": {
      "type": "object",
      "required": ["id"],
      "additionalProperties": false,
      "properties": {
        "id": {"$ref": "#/$defs/name", "description": "Unique among the features."},
        "group": {"$ref": "#/$defs/name", "description": "Id of a group whose settings apply."},
        "line": {
          "type": "object",
          "required": ["source", "destination"],
          "additionalProperties": false,
          "properties": {"source": {"$ref": "#/$defs/ends"}, "destination": {"$ref": "#/$defs/ends"}}
        },
        "point": {
          "type": "object",
          "required": ["source", "destination"],
          "additionalProperties": false,
          "properties": {"source": {"$ref": "#/$defs/xy"}, "destination": {"$ref": "#/$defs/xy"}}
        },
        "curve": {
          "type": "object",
          "required": ["source", "destination"],
          "additionalProperties": false,
          "properties": {
            "source": {"$ref": "#/$defs/points"},
            "destination": {"$ref": "#/$defs/points"},
            "spline": {"enum": ["polyline", "catmull-rom", "bezier"], "description": "Default: catmull-rom."},
            "closed": {"type": "boolean", "description": "Whether the last point is joined to the first. Default: false."}
          }
        },
        "warp": {"$ref": "#/$defs/influence"},
        "transition": {"$ref": "#/$defs/progress"}
      },
      "oneOf": [{"required": ["line"]}, {"required": ["point"]}, {"required": ["curve"]}]
    },
    "timing": {
      "anyOf": [
        {"enum": ["linear", "sine", "sinusoidal", "parabolic", "cubic-bezier", "step", "ease", "ease-in", "ease-out", "ease-in-out"]},
        {
          "type": "object",
          "additionalProperties": false,
          "properties": {
            "ease": {"enum": ["linear", "sine", "ease", "ease-in", "ease-out", "ease-in-out"]},
            "delay": {"$ref": "#/$defs/delay"}, "duration": {"$ref": "#/$defs/duration"}
          }
        },
        {
          "type": "object",
          "required": ["ease"],
          "additionalProperties": false,
          "properties": {
            "ease": {"const": "sinusoidal"},
            "k1": {"$ref": "#/$defs/fraction", "description": "End of the ease-in. Default: 0.3."},
            "k2": {"$ref": "#/$defs/fraction", "description": "Start of the ease-out. Default: 0.7."},
            "delay": {"$ref": "#/$defs/delay"}, "duration": {"$ref": "#/$defs/duration"}
          }
        },
        {
          "type": "object",
          "required": ["ease"],
          "additionalProperties": false,
          "properties": {
            "ease": {"const": "parabolic"},
            "t1": {"$ref": "#/$defs/fraction", "description": "End of the acceleration. Default: 0.3."},
            "t2": {"$ref": "#/$defs/fraction", "description": "Start of the deceleration. Default: 0.7."},
            "delay": {"$ref": "#/$defs/delay"}, "duration": {"$ref": "#/$defs/duration"}
          }
        },
        {
          "type": "object",
          "required": ["ease"],
          "additionalProperties": false,
          "properties": {
            "ease": {"const": "cubic-bezier"},
            "handles": {
              "type": "array",
              "prefixItems": [{"$ref": "#/$defs/fraction"}, {"$ref": "#/$defs/coordinate"}, {"$ref": "#/$defs/fraction"}, {"$ref": "#/$defs/coordinate"}],
              "minItems": 4, "maxItems": 4,
              "description": "[x1, y1, x2, y2] as in CSS. Default: [0.25, 0.1, 0.25, 1]."
            },
            "delay": {"$ref": "#/$defs/delay"}, "duration": {"$ref": "#/$defs/duration"}
          }
        },
        {
          "type": "object",
          "required": ["ease"],
          "additionalProperties": false,
          "properties": {
            "ease": {"const": "step"},
            "at": {"$ref": "#/$defs/fraction", "description": "When it jumps. Default: 0.5."},
            "delay": {"$ref": "#/$defs/delay"}, "duration": {"$ref": "#/$defs/duration"}
          }
        },
        {
          "type": "object",
          "required": ["ease", "keys"],
          "additionalProperties": false,
          "properties": {
            "ease": {"const": "keys"},
            "keys": {
              "type": "array", "minItems": 2, "maxItems": 100000,
              "items": {
                "type": "array",
                "prefixItems": [{"$ref": "#/$defs/fraction"}, {"$ref": "#/$defs/coordinate"}, {"$ref": "#/$defs/coordinate"}],
                "minItems": 2, "maxItems": 3
              },
              "description": "[time, progress] or [time, progress, speed]; times rise from 0 to 1."
            },
            "delay": {"$ref": "#/$defs/delay"}, "duration": {"$ref": "#/$defs/duration"}
          }
        }
      ],
      "description": "Progress as a function of time: the name of an easing, or an object with its parameters."
    },
    "delay": {"$ref": "#/$defs/fraction", "description": "Fraction of the transition before anything happens. Default: 0."},
    "duration": {"$ref": "#/$defs/fraction", "description": "Fraction of the transition that it takes; delay + duration at most 1. Default: what is left after the delay."}
  }
}
)json";

}  // namespace

std::string schema_text() {
  return std::string(kRoot) + kDefinitions;
}

}  // namespace morphkit::project
