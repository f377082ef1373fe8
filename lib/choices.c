#include "choices.h"

#include "keys.h"

#include <math.h>

#define NUMBER(member) .kind = KEY_NUMBER, .place = offsetof(struct choices, member)
#define RANGE(member)  NUMBER(member), .unit = "1", .size = 2, .rising = true

static const char *const standards[] = {"iso", "astm", NULL};
static const double usual_hardening[] = {0.02, 0.2}, usual_fit[] = {0.002, 10};

static const struct key rows[] = {
    {"title", KEY_TEXT, offsetof(struct choices, title), .otherwise = "the deck's, else the file's",
     .help = "name of the curve"},
    {"question", KEY_TEXT, offsetof(struct choices, question), .otherwise = "none",
     .help = "that the run is to answer, for its report"},
    {"license", KEY_TEXT, offsetof(struct choices, license), .otherwise = "not stated",
     .form = "name or address", .help = "under which a crate's data may be used: CC-BY-4.0"},
    {"gauge_length", NUMBER(gauge_length), .unit = "m", .low = 1e-12, .high = 1e3, .usual = NAN,
     .otherwise = "the history's", .help = "initial gauge length"},
    {"section", NUMBER(section), .unit = "m2", .low = 1e-24, .high = 1e6, .usual = NAN,
     .otherwise = "the history's", .help = "initial section"},
    {"modulus_range", RANGE(modulus_range), .low = 0, .high = 1, .usual = NAN,
     .otherwise = "the file's, else 0.1 and 0.4",
     .help = "fit of the slope, between two shares of Rp0.2"},
    {"modulus_rows", RANGE(modulus_rows), .low = 1, .high = 1e12, .usual = NAN,
     .help = "fit of the slope over these rows instead, counted from 1"},
    {"toe", NUMBER(toe), .unit = "1", .low = -1, .high = 1, .usual = NAN,
     .otherwise = "from the fit of the slope", .help = "strain at zero stress"},
    {"modulus", NUMBER(modulus), .unit = "Pa", .low = 1, .high = 1e15, .usual = NAN,
     .otherwise = "the measured slope", .help = "Young's modulus in the plastic strain"},
    {"true_modulus", NUMBER(true_modulus), .unit = "Pa", .low = 1, .high = 1e15, .usual = NAN,
     .help =
         "replaces the measured slope in all strains: removes the compliance of a testing machine"},
    {"hardening_range", RANGE(hardening_range), .low = 0, .high = 10, .usuals = usual_hardening,
     .help = "engineering plastic strain for n and K, at most Ag"},
    {"fit_range", RANGE(fit_range), .low = 0, .high = 10, .usuals = usual_fit,
     .help = "true plastic strain for the hardening laws, at most to maximum force"},
    {"window", NUMBER(window), .unit = "1", .low = 1e-9, .high = 1, .usual = 0.01,
     .help = "true strain over which slopes are taken"},
    {"yield_drop", NUMBER(yield_drop), .unit = "1", .low = 0, .high = 1, .usual = 0.005,
     .help = "fall of stress, a share, that makes an upper yield point"},
    {"standard", KEY_CHOICE, offsetof(struct choices, standard), .names = standards,
     .usual = STANDARD_ISO,
     .help = "where ISO 6892-1 and ASTM E8, E646 differ: upper yield point, strain of n"},
    {"loop_offset", NUMBER(loop_offset), .unit = "1", .low = 1e-7, .high = 0.1, .usual = 1e-4,
     .help = "strain off the elastic line at which a branch of a loop yields"},
    {"resolution_order", NUMBER(resolution_order), .unit = "1", .low = 0.25, .high = 4, .usual = 1,
     .help = "power of the spacing with which errors fall, in extrapolations that do not tell it"},
    {"fracture_share", NUMBER(fracture_share), .unit = "1", .low = 0, .high = 1, .usual = 0.1,
     .help = "share of the highest stress; the specimen counts as broken where it falls below"},
};

const struct section post_section = {
    .path = "post",
    .help = "How hspost makes a curve of a history. Each key is an option of hspost, too, and the "
            "option stands over it.",
    .keys = KEYS(rows),
};
