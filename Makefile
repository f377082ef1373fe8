# hstools - one Makefile for everything; nothing is written beside the sources.
#
#   make                 programs in build/bin
#   make check           all tests (under ten minutes on two cores)
#   make install         DESTDIR and PREFIX as usual: programs, manual pages, examples, documents, completion of bash and zsh
#   make html            the manual pages as HTML (mandoc)
#   make deb             a Debian package of the last commit (debhelper, lintian)
#   make stress          numerical stability, the long form (minutes)
#   make faults          disks that fail and kills at each call of small runs (some ten minutes)
#   make fuzz fuzz-runs  changed files, by libFuzzer, FUZZ_SECONDS=600 for each reader; runs of 10,000 changed decks
#   make check-report    reports in a browser: errors, overflow, contrast (chromium)
#   make check-paraview  fields in ParaView, by docs/open_fields.py (paraview, xvfb)
#   make check-slurm     studies as job arrays, on a Slurm of one node of its own (packages slurm-wlm, munge; three minutes)
#   make bench           kernels beside their bounds and LAMMPS, whole runs, run time against error: docs/bench;
#                        QUICK=1: kernels alone
#   make bench-compare REV=...  kernels and whole runs beside those of an earlier commit
#   make docs            the keys of the deck and the columns into docs/deck.md, docs/formats.md and docs/man/hsdeck.5
#   make format          clang-format over the tree
#   make first           the small study of the README
#   make hs40 study      the larger ones of pipelines/ (minutes to an hour)
#   make studies         all studies in their small forms, each through its own check, a line each (some twenty minutes)
#   make mutations       breaks the code in some 180 places, one at a time, and says which test notices (hours)
#
# Options: CC=clang, WERROR=1 (warnings are errors), SANITIZE=1 (ASan and UBSan, own build tree).

VERSION := 0.1.0
# "0.1.0+12.g8e158c7", commits since the tag v0.1.0, or since the first, and the last one; ".changed" where the tree is not that
# of the commit.  Without git, or outside of a repository of its own: "0.1.0".
DESCRIBED := $(VERSION)$(shell [ -e .git ] && { \
    count=$$(git rev-list --count HEAD ^v$(VERSION) 2>/dev/null || git rev-list --count HEAD 2>/dev/null) && \
    hash=$$(git rev-parse --short HEAD 2>/dev/null) && \
    { [ "$$count" -eq 0 ] || printf '+%s.g%s' "$$count" "$$hash"; } && \
    { git diff --quiet HEAD 2>/dev/null || printf '.changed'; }; })
PREFIX ?= /usr/local
CC ?= cc
CFLAGS ?=
LDFLAGS ?=
JOBS ?= 2

ifdef SANITIZE
BUILD ?= build/sanitize
else
BUILD ?= build
endif

# Results must not depend on the vector width or on the part of the lattice a rank holds: no
# contraction of a * b + c, no reassociation.
STANDARD := -std=c11 -D_GNU_SOURCE
OPTIMISE := -O3 -g -fno-math-errno -fno-trapping-math -ffp-contract=off -fopenmp-simd
# Integer constants are enumerators here, ints as the standard has them, of which clang 19 wants casts.
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-enum-float-conversion \
            -Wstrict-prototypes -Wmissing-prototypes -Wvla $(if $(WERROR),-Werror)
comma := ,
SANITIZERS := $(if $(SANITIZE),-fsanitize=address$(comma)undefined -fno-omit-frame-pointer -O1 \
              -DHS_SANITIZE)

PKG_CONFIG ?= pkg-config
package = $(or $(shell $(PKG_CONFIG) $(1) $(2) 2>/dev/null),$(3))
LIB_CFLAGS := $(call package,--cflags,yaml-0.1 netcdf gsl muparser,) $(call package,--cflags,udunits,)
# Debian's shared Exodus drags in an MPI build of netCDF beside the serial one; the archive does not.
EXODUS_LIBS ?= -l:libexoIIv2c.a
LIB_LIBS := $(EXODUS_LIBS) $(call package,--libs,netcdf,-lnetcdf) $(call package,--libs,yaml-0.1,-lyaml) \
            $(call package,--libs,gsl,-lgsl -lgslcblas) $(call package,--libs,udunits,-ludunits2) -lm
EXPRESSION_LIBS := $(call package,--libs,muparser,-lmuparser)
CAIRO_CFLAGS := $(call package,--cflags,cairo,)
CAIRO_LIBS := $(call package,--libs,cairo,-lcairo)
IMAGE_CFLAGS := $(call package,--cflags,libtiff-4 libpng zlib,) \
                $(call package,--cflags,hdf5-serial,-I/usr/include/hdf5/serial)
IMAGE_LIBS := $(call package,--libs,libtiff-4 libpng zlib,-ltiff -lpng -lz) \
              $(call package,--libs,hdf5-serial,-lhdf5_serial) -lbz2
EXPAT_LIBS := $(call package,--libs,expat,-lexpat)
JANSSON_LIBS := $(call package,--libs,jansson,-ljansson)
MPI_CFLAGS := $(patsubst -I%,-isystem %,$(call package,--cflags,ompi-c,))
MPI_LIBS := $(call package,--libs,ompi-c,-lmpi)
METIS_LIBS ?= -lmetis
FFTW_LIBS := $(call package,--libs,fftw3f,-lfftw3f)
CMOCKA_LIBS := $(call package,--libs,cmocka,-lcmocka)

ALL_CFLAGS = $(STANDARD) $(OPTIMISE) $(WARNINGS) $(SANITIZERS) $(LIB_CFLAGS) -Ilib $(CFLAGS)
ALL_LDFLAGS = $(SANITIZERS) $(LDFLAGS)

PROGRAMS := hsgen hssolve hspost
EXAMPLES := $(sort $(wildcard gen/examples/*.yaml))
lib_SOURCES := $(sort $(wildcard lib/*.c))
gen_SOURCES := $(sort $(filter-out gen/hsgen.c,$(wildcard gen/*.c)))
solve_SOURCES := $(sort $(filter-out solve/hssolve.c,$(wildcard solve/*.c solve/*/*.c solve/*/*/*.c)))
post_SOURCES := $(sort $(filter-out post/hspost.c,$(wildcard post/*.c)))
test_SOURCES := $(sort $(wildcard tests/unit/test_*.c tests/physics/test_*.c))

SOLVE_INCLUDES := $(patsubst %/,-I%,$(sort $(dir $(wildcard solve/*.h solve/*/*.h solve/*/*/*.h))))

object = $(patsubst %.c,$(BUILD)/%.o,$(1))
archive = $(BUILD)/lib$(1).a

.PHONY: all check check-unit check-cli check-physics check-report check-paraview check-format docs html deb install uninstall clean format help \
        stress faults check-slurm fuzz fuzz-runs mutations bench bench-tables bench-compare
.DELETE_ON_ERROR:
.SECONDARY:

all: $(addprefix $(BUILD)/bin/,$(PROGRAMS))

$(BUILD)/gen/%.o: ALL_CFLAGS += -Igen $(IMAGE_CFLAGS)
$(BUILD)/post/%.o: ALL_CFLAGS += -Ipost
$(BUILD)/solve/%.o: ALL_CFLAGS += $(SOLVE_INCLUDES) $(MPI_CFLAGS)
$(BUILD)/tests/%.o: ALL_CFLAGS += $(IMAGE_CFLAGS) -Igen -Ipost -Itests -Itests/physics $(SOLVE_INCLUDES) $(MPI_CFLAGS)
$(BUILD)/lib/canvas.o: ALL_CFLAGS += $(CAIRO_CFLAGS)
$(BUILD)/lib/version.o: ALL_CFLAGS += -DHS_VERSION='"$(VERSION)"'
$(BUILD)/gen/examples.o: $(EXAMPLES)

# The programs say the commit that they are made of; the tests, of which there are many, are not linked anew for each.
$(BUILD)/version/version.o: lib/version.c Makefile $(BUILD)/version/described
	$(CC) $(ALL_CFLAGS) $(CPPFLAGS) -DHS_VERSION='"$(DESCRIBED)"' -c $< -o $@
ifneq ($(DESCRIBED),$(file <$(BUILD)/version/described))
.PHONY: $(BUILD)/version/described
endif
$(BUILD)/version/described:
	@mkdir -p $(@D)
	@printf '%s' '$(DESCRIBED)' >$@

$(BUILD)/%.o: %.c Makefile
	@mkdir -p $(@D)
	$(CC) $(ALL_CFLAGS) $(CPPFLAGS) -MMD -MP -c $< -o $@

define ARCHIVE
$(call archive,$(1)): $$(call object,$$($(1)_SOURCES))
	@rm -f $$@
	$(AR) rcs $$@ $$^
endef
$(foreach part,lib gen solve post,$(eval $(call ARCHIVE,$(part))))

$(BUILD)/bin/hsgen: $(BUILD)/version/version.o $(BUILD)/gen/hsgen.o $(call archive,gen) $(call archive,lib)
$(BUILD)/bin/hsgen: LIBRARIES = $(LIB_LIBS) $(CAIRO_LIBS) $(IMAGE_LIBS) $(EXPAT_LIBS)
$(BUILD)/bin/hssolve: $(BUILD)/version/version.o $(BUILD)/solve/hssolve.o $(call archive,solve) $(call archive,lib)
$(BUILD)/bin/hssolve: LIBRARIES = $(LIB_LIBS) $(EXPRESSION_LIBS) $(METIS_LIBS) $(FFTW_LIBS) $(MPI_LIBS)
$(BUILD)/bin/hspost: $(BUILD)/version/version.o $(BUILD)/post/hspost.o $(call archive,post) $(call archive,lib)
$(BUILD)/bin/hspost: LIBRARIES = $(LIB_LIBS) $(CAIRO_LIBS) $(JANSSON_LIBS)

$(addprefix $(BUILD)/bin/,$(PROGRAMS)):
	@mkdir -p $(@D)
	$(CC) $(ALL_LDFLAGS) $(filter %.o %.a,$^) $(LIBRARIES) -o $@

# Tests: every tests/*/test_*.c is a program of its own, linked to all that the tools are made of.
TESTS := $(patsubst tests/%.c,$(BUILD)/tests/%,$(test_SOURCES))
$(TESTS): $(BUILD)/tests/%: $(BUILD)/tests/%.o $(foreach part,gen solve post lib,$(call archive,$(part)))
	$(CC) $(ALL_LDFLAGS) $(filter %.o,$^) $(filter %.a,$^) $(LIB_LIBS) $(EXPRESSION_LIBS) $(CAIRO_LIBS) $(IMAGE_LIBS) $(EXPAT_LIBS) $(JANSSON_LIBS) $(METIS_LIBS) $(FFTW_LIBS) $(MPI_LIBS) $(CMOCKA_LIBS) -o $@
$(filter $(BUILD)/tests/physics/%,$(TESTS)): $(addprefix $(BUILD)/tests/physics/,small_body.o small_static.o scene_body.o)

# Readers of files on changed ones; FUZZER=1: by libFuzzer, which has a main of its own.
$(BUILD)/tests/fuzz/fuzz: $(BUILD)/tests/fuzz/targets.o $(BUILD)/tests/fuzz/targets_post.o $(if $(FUZZER),,$(BUILD)/tests/fuzz/drive.o) \
    $(foreach part,gen solve post lib,$(call archive,$(part)))
	$(CC) $(ALL_LDFLAGS) $(if $(FUZZER),-fsanitize=fuzzer) $(filter %.o,$^) $(filter %.a,$^) $(LIB_LIBS) $(EXPRESSION_LIBS) $(CAIRO_LIBS) $(IMAGE_LIBS) $(EXPAT_LIBS) $(JANSSON_LIBS) $(METIS_LIBS) $(FFTW_LIBS) $(MPI_LIBS) -o $@

# Not a test: prints the table of errors (pipelines/errors).
$(BUILD)/tests/physics/errors: $(BUILD)/tests/physics/errors.o $(BUILD)/tests/physics/small_body.o \
    $(BUILD)/tests/physics/small_static.o $(foreach part,gen solve post lib,$(call archive,$(part)))
	$(CC) $(ALL_LDFLAGS) $(filter %.o,$^) $(filter %.a,$^) $(LIB_LIBS) $(EXPRESSION_LIBS) $(CAIRO_LIBS) $(IMAGE_LIBS) $(EXPAT_LIBS) $(JANSSON_LIBS) $(METIS_LIBS) $(FFTW_LIBS) $(MPI_LIBS) $(CMOCKA_LIBS) -o $@

# Not a test: times of the kernels beside the bounds of the machine.
$(BUILD)/tests/bench/kernels: $(BUILD)/tests/bench/kernels.o $(BUILD)/tests/physics/small_body.o \
    $(foreach part,gen solve post lib,$(call archive,$(part)))
	$(CC) $(ALL_LDFLAGS) $(filter %.o,$^) $(filter %.a,$^) $(LIB_LIBS) $(EXPRESSION_LIBS) $(CAIRO_LIBS) $(IMAGE_LIBS) $(EXPAT_LIBS) $(JANSSON_LIBS) $(METIS_LIBS) $(FFTW_LIBS) $(MPI_LIBS) $(CMOCKA_LIBS) -o $@

# Not a test: a spectral solver of the same voxels, beside which load steps of periodic cells stand.
$(BUILD)/tests/bench/spectral: $(BUILD)/tests/bench/spectral.o $(call archive,lib)
	$(CC) $(ALL_LDFLAGS) $(filter %.o,$^) $(filter %.a,$^) $(LIB_LIBS) $(call package,--libs,fftw3,-lfftw3) -o $@

# QUICK=1: the kernels on 64,000 nodes alone, to standard output.
BENCH := $(BUILD)/results/bench
bench: all $(BUILD)/tests/bench/kernels $(BUILD)/tests/bench/spectral
	@mkdir -p $(BENCH)
	@$(BUILD)/tests/bench/kernels > $(BENCH)/measured.csv
	@tests/bench/lammps > $(BENCH)/lammps.txt
	@awk -f tests/bench/join.awk $(BENCH)/measured.csv $(BENCH)/lammps.txt > $(BENCH)/kernels.csv
	@cat $(BENCH)/kernels.csv
ifndef QUICK
	@mkdir -p docs/bench
	$(BUILD)/tests/bench/kernels 500 100 40 > $(BENCH)/large.csv
	+$(MAKE) -s BUILD=$(BUILD)/avx2 CPPFLAGS=-DHS_NO_AVX512 $(BUILD)/avx2/tests/bench/kernels
	$(BUILD)/avx2/tests/bench/kernels > $(BENCH)/measured-avx2.csv
	{ cat $(BENCH)/kernels.csv; sed -e 1d -e 's/$$/,/' $(BENCH)/large.csv; \
	    awk -f tests/bench/join.awk $(BENCH)/measured-avx2.csv $(BENCH)/lammps.txt | sed 1d; } > docs/bench/kernels.csv
	PATH=$(abspath $(BUILD)/bin):$$PATH tests/bench/runs $(BENCH)/runs > docs/bench/runs.csv
	PATH=$(abspath $(BUILD)/bin):$$PATH tests/bench/load-steps $(BENCH)/load-steps > docs/bench/load-steps.csv
	PATH=$(abspath $(BUILD)/bin):$$PATH tests/bench/accuracy $(BENCH)/accuracy > docs/bench/accuracy.csv
	PATH=$(abspath $(BUILD)/bin):$$PATH tests/bench/error $(BENCH)/error all > docs/bench/error.csv
	PATH=$(abspath $(BUILD)/bin):$$PATH pipelines/truths/cell $(BENCH)/cells cost > docs/bench/cells.csv
	tests/bench/periodic $(BUILD) $(BENCH)/periodic > docs/bench/periodic.csv
	if command -v ccx > /dev/null; then PATH=$(abspath $(BUILD)/bin):$$PATH tests/bench/elements $(BENCH)/elements > docs/bench/elements.csv; fi
	$(MAKE) bench-tables
endif

bench-tables:
	gnuplot -c tests/bench/error.gp docs/bench/error.csv tests/bench/front.awk docs/bench/error.svg
	awk -f tests/bench/front.awk docs/bench/error.csv > docs/bench/error.md
	gnuplot -c tests/bench/runs.gp docs/bench/runs.csv docs/bench/runs.svg
	for name in kernels runs load-steps; do awk -f tests/bench/table.awk docs/bench/$$name.csv > docs/bench/$$name.md; done

bench-compare: all $(BUILD)/tests/bench/kernels
	@tests/bench/compare $(or $(REV),HEAD) $(BUILD) $(abspath $(BENCH))

PROVE := HS_BUILD=$(abspath $(BUILD)) prove --jobs $(JOBS) --exec tests/run

check: all $(TESTS) $(BUILD)/tests/fuzz/fuzz check-format
	$(PROVE) $(sort $(TESTS)) $(sort $(wildcard tests/cli/*.bats tests/physics/*.bats tests/stress/*.bats tests/faults/*.bats tests/fuzz/*.bats))

# Faults of the disk and kills at each call that small runs make, of which check has some.
faults: all
	ALL=1 $(PROVE) $(sort $(wildcard tests/faults/*.bats))

check-slurm: all
	$(PROVE) tests/slurm/slurm.bats

# Guided by coverage, under the sanitizers: FUZZ_SECONDS for each target; and whole runs of 10,000 changed decks.
FUZZ_SECONDS ?= 600
fuzz:
	+$(MAKE) BUILD=$(BUILD)/fuzz CC=clang SANITIZE=1 FUZZER=1 CFLAGS=-fsanitize=fuzzer-no-link all
	+$(MAKE) BUILD=$(BUILD)/fuzz CC=clang SANITIZE=1 FUZZER=1 CFLAGS=-fsanitize=fuzzer-no-link $(BUILD)/fuzz/tests/fuzz/fuzz
	PATH=$(abspath $(BUILD)/fuzz/bin):$$PATH tests/fuzz/guided $(BUILD)/fuzz $(FUZZ_SECONDS)

fuzz-runs:
	+$(MAKE) BUILD=$(BUILD)/sanitize SANITIZE=1 all
	PATH=$(abspath $(BUILD)/sanitize/bin):$$PATH tests/fuzz/runs 10000 $(BUILD)/results/fuzz-runs

# Reports in a browser (chromium): console, overflow, contrast; the pages stay in $(BUILD)/results/report.
check-report: all
	PATH=$(abspath $(BUILD)/bin):$$PATH tests/report/check $(BUILD)/results/report

# Fields as docs/open_fields.py shows them (paraview, xvfb).
check-paraview: all
	PATH=$(abspath $(BUILD)/bin):$$PATH tests/report/paraview $(BUILD)/results/paraview

# Numerical stability: the long form of what check has in short.
stress: all
	LONG=1 $(PROVE) $(sort $(wildcard tests/stress/*.bats))

# Tests of the tests; no part of check.
mutations:
	BUILD=$(BUILD) tests/mutate

check-unit: $(TESTS)
	$(PROVE) $(filter $(BUILD)/tests/unit/%,$(TESTS))

check-cli: all
	$(PROVE) $(sort $(wildcard tests/cli/*.bats))

check-physics: all $(TESTS)
	$(PROVE) $(filter $(BUILD)/tests/physics/%,$(TESTS)) $(sort $(wildcard tests/physics/*.bats))

# The keys that the programs know, into the manuals.
docs: all
	PATH=$(abspath $(BUILD)/bin):$$PATH docs/keys docs/deck.md docs/formats.md docs/man/hsdeck.5

FORMATTED := $(shell find lib gen solve post tests -name '*.[ch]')
CLANG_FORMAT ?= clang-format
format:
	$(CLANG_FORMAT) -i $(FORMATTED)
# Versions differ in what they make of one .clang-format.
check-format:
	@if $(CLANG_FORMAT) --version 2>/dev/null | grep -q 'version 14\.'; then $(CLANG_FORMAT) --dry-run -Werror $(FORMATTED); \
	else echo "check-format: skipped, no $(CLANG_FORMAT) 14" >&2; fi

# The manual pages as HTML, where there is mandoc.
PAGES := $(sort $(wildcard docs/man/*.[15]))
HTML := $(PAGES:docs/man/%=$(BUILD)/html/%.html)
html: $(HTML)
$(BUILD)/html/%.html: docs/man/%
	@mkdir -p $(@D)
	mandoc -T html -O man=%N.%S.html $< > $@

SHARE := $(DESTDIR)$(PREFIX)/share
DOCUMENTS := $(SHARE)/doc/hstools
BASH_COMPLETIONS := $(SHARE)/bash-completion/completions
ZSH_COMPLETIONS := $(SHARE)/zsh/site-functions
install: all $(if $(shell command -v mandoc),html)
	install -d $(DESTDIR)$(PREFIX)/bin $(SHARE)/man/man1 $(SHARE)/man/man5 $(DOCUMENTS)/examples $(DOCUMENTS)/docs/figures \
	    $(DOCUMENTS)/html $(BASH_COMPLETIONS) $(ZSH_COMPLETIONS)
	install -m 755 $(addprefix $(BUILD)/bin/,$(PROGRAMS)) $(DESTDIR)$(PREFIX)/bin
	install -m 644 $(wildcard docs/man/*.1) $(SHARE)/man/man1
	install -m 644 $(wildcard docs/man/*.5) $(SHARE)/man/man5
	install -m 644 $(EXAMPLES) $(DOCUMENTS)/examples
	install -m 644 README.md LICENSE $(DOCUMENTS)
	install -m 644 $(wildcard docs/*.md) docs/open_fields.py docs/CITATION.cff docs/codemeta.json docs/paper.bib $(DOCUMENTS)/docs
	install -m 644 $(wildcard docs/figures/*) $(DOCUMENTS)/docs/figures
	$(if $(shell command -v mandoc),install -m 644 $(HTML) $(DOCUMENTS)/html)
	for program in $(PROGRAMS); do \
	    $(BUILD)/bin/$$program --completion bash > $(BASH_COMPLETIONS)/$$program && \
	    $(BUILD)/bin/$$program --completion zsh > $(ZSH_COMPLETIONS)/_$$program || exit 1; \
	done
uninstall:
	rm -f $(addprefix $(DESTDIR)$(PREFIX)/bin/,$(PROGRAMS))
	rm -f $(addprefix $(SHARE)/man/man1/,$(notdir $(wildcard docs/man/*.1)))
	rm -f $(addprefix $(SHARE)/man/man5/,$(notdir $(wildcard docs/man/*.5)))
	rm -f $(addprefix $(BASH_COMPLETIONS)/,$(PROGRAMS)) $(addprefix $(ZSH_COMPLETIONS)/_,$(PROGRAMS))
	rm -rf $(DOCUMENTS)

# hstools_VERSION_ARCHITECTURE.deb of the last commit, in $(BUILD)/deb; packages debhelper and, for its checks, lintian.
deb:
	.packaging/build $(BUILD)/deb $(DESCRIBED)

clean:
	rm -rf build

help:
	@sed -n '3,26s/^# \{0,1\}//p' $(firstword $(MAKEFILE_LIST))

-include pipelines/pipelines.mk
-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
