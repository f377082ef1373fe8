#include "study_make.h"

#include <stdbool.h>
#include <string.h>

/* What does not depend on the study.  One shell runs a whole recipe (.ONESHELL).  A run that fails
 * says so and leaves the others alone: its target is not there, which the last line tells and the
 * next make tries again. */
static const char head[] = "# Made by hsgen --study; made anew by it.\n"
                           "#\n"
                           "#   make -j4            runs what is missing or older than its deck, "
                           "four at a time, then gathers\n"
                           "#   make runs           only runs\n"
                           "#   make gathered       gathers what there is\n"
                           "#   make report         a page of what there is: gathered/report.html\n"
                           "#   make columns        NNNN/columns.csv: all columns of each history, "
                           "which a body without grips has, too\n"
                           "#   make status         what is done, stopped, failed\n"
                           "#\n"
                           "# RANKS=N: ranks of each run.  FIELDS=yes: fields for ParaView, too.  "
                           "HSSOLVE_FLAGS='--time-limit \"2 h\"'\n"
                           "# A run that was stopped (a signal, a time limit) goes on from its "
                           "checkpoint with the next make.\n"
                           "# LAUNCH='srun --input=0': ranks that a batch system starts.\n"
                           "\n"
                           "RANKS ?= 1\n"
                           "LAUNCH ?=\n"
                           "HSSOLVE_FLAGS ?=\n"
                           "SHELL := /bin/bash\n"
                           ".SHELLFLAGS := -o pipefail -c\n"
                           ".ONESHELL:\n"
                           ".DELETE_ON_ERROR:\n"
                           ".SECONDARY:\n"
                           ".PHONY: all runs gathered report columns status\n"
                           "\n";

/* With a resolution, curves and figure at the spacing 0. */
static const char extrapolation[] =
    "EXTRAPOLATED = gathered/extrapolated.csv\n"
    "EXTRAPOLATE = hspost -q --files-from gathered/files --extrapolate gathered/extrapolated.csv "
    "\\\n"
    "    --extrapolate-properties gathered/extrapolated_properties.csv \\\n"
    "    --band --plot gathered/extrapolated.svg >/dev/null\n";

static const char sensitivity[] = "SENSITIVITY = --sensitivities gathered/sensitivities.csv\n";

static const char rules[] =
    "\n"
    "all: gathered/tidy.csv $(EXTRAPOLATED)\n"
    "\t@$(REPORT)\n"
    "runs: $(RUNS:%=%/curve.csv)\n"
    "\t@$(REPORT)\n"
    "gathered:\n"
    "\t@$(GATHER)\n"
    "\t$(EXTRAPOLATE)\n"
    "report:\n"
    "\t@$(LIST)\n"
    "\thspost -q --files-from gathered/files --report gathered/report.html \\\n"
    "\t    $(patsubst %,--frames %,$(firstword $(wildcard $(RUNS:%=%/fields.e)))) >/dev/null\n"
    "\techo \"$$PWD/gathered/report.html\"\n"
    "columns: $(RUNS:%=%/columns.csv)\n"
    "\t@$(REPORT)\n"
    "status:\n"
    "\t@$(REPORT)\n"
    "\n"
    "# Standard error of all three programs is in the run's log.\n"
    "$(RUNS:%=%/history.e): %/history.e: %/deck.yaml\n"
    "\t@rm -f $*/failed $*/stopped\n"
    "\tfiles=(-q -j $(RANKS) $(HSSOLVE_FLAGS) $(if $(FIELDS),-o $*/fields.e) --checkpoint "
    "$*/checkpoint -H $*/run.e)\n"
    "\tif [ $*/checkpoint -nt $< ]; then\n"
    "\t    echo \"$*: goes on from its checkpoint\"\n"
    "\t    $(LAUNCH) hssolve \"$${files[@]}\" --restart $*/checkpoint 2>>$*/log &\n"
    "\telse\n"
    "\t    echo \"$*\"\n"
    "\t    rm -f $*/checkpoint $*/checkpoint.1\n"
    "\t    hsgen -q $< 2>$*/log | $(LAUNCH) hssolve \"$${files[@]}\" 2>>$*/log &\n"
    "\tfi\n"
    "\tsolver=$$!\n"
    "\ttrap 'kill -TERM $$solver 2>/dev/null' TERM INT HUP USR1\n"
    "\twait $$solver; status=$$?\n"
    "\twhile kill -0 $$solver 2>/dev/null; do wait $$solver; status=$$?; done\n"
    "\tif [ $$status -eq 0 ]; then\n"
    "\t    rm -f $*/checkpoint $*/checkpoint.1 $*/run.e.failed\n"
    "\t    mv $*/run.e $@\n"
    "\telif [ $$status -eq 143 ]; then\n"
    "\t    { echo stopped; grep '^hssolve: .*stopped a' $*/log; } | tail -n 1 >$*/stopped\n"
    "\telse\n"
    "\t    { echo \"exit status $$status\"; grep -v 'standard input is empty' $*/log | tail -n 2; "
    "} >$*/failed\n"
    "\t    echo \"$*: failed, see $*/log\" >&2\n"
    "\tfi\n"
    "\n"
    "$(RUNS:%=%/curve.csv): %/curve.csv: %/history.e\n"
    "\t@[ -e $< ] || exit 0\n"
    "\thspost -q $< -o $@ --properties $*/properties.csv 2>>$*/log && exit 0\n"
    "\t{ echo \"hspost\"; tail -n 2 $*/log; } >$*/failed\n"
    "\trm -f $@\n"
    "\techo \"$*: failed, see $*/log\" >&2\n"
    "\n"
    "$(RUNS:%=%/columns.csv): %/columns.csv: %/history.e\n"
    "\t@[ ! -e $< ] || hspost -q --columns $< -o $@\n"
    "\n"
    "gathered/tidy.csv: $(RUNS:%=%/curve.csv)\n"
    "\t@$(GATHER)\n"
    "\n"
    "# Behind the others: where it fails, they are there.\n"
    "gathered/extrapolated.csv: gathered/tidy.csv\n"
    "\t@$(LIST)\n"
    "\t$(EXTRAPOLATE)\n"
    "\n"
    "# The numbers of the runs are the first column of study.csv.\n"
    "NUMBERS = sed -e 1d -e 's/,.*//' study.csv\n"
    "\n"
    "# The cores of the coarsest spacing, which the finer ones take.\n"
    "define CORES\n"
    "mkdir -p cores\n"
    "hsgen -q $< --override --cores $@ 2>$@.log >/dev/null || cat $@.log >&2\n"
    "endef\n"
    "\n"
    "define LIST\n"
    "mkdir -p gathered\n"
    "$(NUMBERS) | while read -r run; do [ ! -e $$run/curve.csv ] || echo $$run/history.e; done "
    ">gathered/files\n"
    "[ -s gathered/files ] || exit 0\n"
    "set -e\n"
    "endef\n"
    "\n"
    "define GATHER\n"
    "$(LIST)\n"
    "hspost -q --files-from gathered/files --properties gathered/properties.csv $(SENSITIVITY) "
    "\\\n"
    "    --mean gathered/mean.csv --statistics gathered/statistics.csv \\\n"
    "    --band --plot gathered/curves.svg --tidy gathered/tidy.csv >/dev/null\n"
    "endef\n"
    "\n"
    "define REPORT\n"
    "done=0 missing=0 stopped=0 failed=0\n"
    "while read -r run; do\n"
    "    if [ -e $$run/failed ]; then\n"
    "        failed=$$((failed + 1)); echo \"$$run failed: $$(tr '\\n' ' ' <$$run/failed)\" >&2\n"
    "    elif [ -e $$run/history.e ]; then done=$$((done + 1))\n"
    "    elif [ -e $$run/stopped ]; then\n"
    "        stopped=$$((stopped + 1)); echo \"$$run stopped: goes on with the next make\" >&2\n"
    "    else missing=$$((missing + 1)); fi\n"
    "done < <($(NUMBERS))\n"
    "echo \"$$done runs done, $$missing not run, $$stopped stopped, $$failed failed$$([ ! -e "
    "gathered/tidy.csv ] || echo \"; gathered in $$PWD/gathered\")\"\n"
    "[ $$((stopped + failed)) -eq 0 ]\n"
    "endef\n";

/* Makes the files of cores that were not named before. */
static void write_cores(FILE *file, const struct study_make *study)
{
    for (int i = 0; i < study->count; i++) {
        if (!study->cores[i]) continue;
        bool named = false;
        for (int k = i - 1; k >= 0 && !named; k--)
            named = study->makers[k] == study->makers[i] && study->cores[k];
        fprintf(file, "%04ld/history.e: %s\n", study->numbers[i], study->cores[i]);
        if (!named)
            fprintf(file, "%s: %04ld/deck.yaml\n\t@$(CORES)\n", study->cores[i], study->makers[i]);
    }
}

bool study_make_wrote(const char *path)
{
    char line[128] = "";
    FILE *file = fopen(path, "r");
    if (!file) return false;
    const bool read = fgets(line, sizeof line, file) != NULL;
    fclose(file);
    return read && strncmp(line, head, strcspn(head, "\n") + 1) == 0;
}

void study_make_write(FILE *file, const struct study_make *study)
{
    fputs(head, file);
    fputs("RUNS :=", file);
    for (int i = 0; i < study->count; i++)
        fprintf(file, "%s%04ld", i % 16 == 0 ? " \\\n    " : " ", study->numbers[i]);
    fprintf(file, "\n%s", study->resolution ? extrapolation : "");
    if (study->sensitivity) fputs(sensitivity, file);
    fputs(rules, file);
    write_cores(file, study);
}
