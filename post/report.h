/* report.h - parts of the list of properties. */
#ifndef HS_REPORT_H
#define HS_REPORT_H

#include "analysis.h"

/* Kinetic over internal energy, above which a test is not quasi-static. */
extern const double report_quasi_static_limit;

/* Hardening laws fitted to the curve. */
void report_fits(struct properties *list, const struct analysis *analysis);
/* Phases at maximum force, and the quality of a run. */
void report_phases(struct properties *list, const struct analysis *analysis);
void report_quality(struct properties *list, const struct curve *whole,
                    const struct analysis *analysis);
/* What happened during the test (record.h), and the noise. */
void report_record(struct properties *list, const struct curve *curve,
                   const struct analysis *analysis);

#endif
