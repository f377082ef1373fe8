# The studies.  Each folder of pipelines/ holds a deck and a short README; each run has a folder of
# its own in $(BUILD)/results with curve.csv, curve.svg, properties.csv, structure.png,
# statistics.csv and hssolve.log, fields.e where the deck is a large one.
#
#   make first                 the small study of the README
#   make errors                errors of the elastic constants, yield and hardening of every material
#   make truths                every formulation where stress varies, against exact solutions and CalculiX: docs/errors.md (half an hour)
#   make plate-cg              the homogeneous plate that proves E and the hardening curve
#   make cells                 harmonic against random at equal fraction, on periodic cells: 320 runs (an hour of one core)
#   make map                   what of a harmonic cell counts: Sobol's indices of seven factors, 1,000 runs (half an hour of one core)
#   make ni-cell               the flagship: a periodic cell of harmonic nickel, yields by Hall and Petch
#   make hs40                  pipelines/ni-hs40
#   make hs40-horizons         the same at horizons 1, 2 and 3 spacings
#   make hs40-rate             the same at half the speed
#   make r40 thesis            its random counterpart; the spheres that 25 um cannot resolve
#   make study                 CG, UFG, HS40 and R40 at two spacings: one figure, one table
#   make study SPACINGS=25um   the same at the coarse spacing alone
#   make bond-plate            E of a bond-based sheet against horizon, spacing and corrections
#   make load-steps            a plate under forces that grow in steps; the plate at rest against plane stress
#   make crack                 a crack in glass that runs and branches: its speed
#   make strip                 energy that a crack takes, slow and running, in a strip where it is known
#   make thesis-impact         grips at 450 and 45 m/s: waves, and where it breaks
#   make thesis-boundary       four ways to hold a plate: which are asymmetric
#   make solvers               evaluations and seconds of load steps, by method, nodes, length, horizon (20 minutes)
#   make loops                 unloading and reloading of CG, UFG, HS40 and R40: back stress
#   make waves                 plane waves against the symbol of the lattice, pulses through bars and plates
#   make fracture-spacing      bars that part by ductile damage, at three spacings, with and without `length`
#
#   make necking-bar           Simo and Hughes' bar against axisymmetric elements, to 7 mm of half elongation
#   make taylor-bar            a copper bar strikes a wall at 227 m/s: its length and its foot
#
#   make decks                 the decks of all studies, as the targets above would run them; nothing is run
#   make studies               every study in its small form and through its check (some twenty minutes of two cores), a line each
#
# FORMULATION=corner: hs40, r40, thesis, study, fracture, loops and spacings, whose decks say correspondence with mix, in that formulation; results in
# build/results-corner.
#
# Several runs side by side are fastest on one rank each: make -j2 RANKS=1 study.
#
# SMALL=yes: the small form of a study, in build/studies: fewer runs, or shorter ones, with what then holds of its check.  Those of the
# horizons and the rate of hs40 have none: a plate of 64,000 particles is to be pulled far for them.
#
# A run is made anew when its deck is newer, not when a program is: remove its folder for that.

RESULTS := $(BUILD)/$(if $(SMALL),studies,results)$(FORMULATION:%=-%)
RANKS ?= $(shell n=$$(nproc); echo $$((n < 2 ? n : 2)))
SPACINGS ?= 25um$(if $(SMALL),, 12.5um)


STUDIES := first cells map ni-cell plate-cg errors truths hs40 r40 thesis study bond-plate load-steps crack thesis-impact thesis-boundary fracture-spacing necking necking-bar taylor-bar fracture \
           solver-switch solvers rates spacings finite-elements loops thesis-calibration strip waves
.PHONY: $(STUDIES) flagship hs40-horizons hs40-rate decks studies

# A check says how many of its assertions hold, or which does not.
small := $(if $(SMALL),/small)
must = awk -v study=$(1) $(2) -f pipelines/must.awk -f pipelines/$(1)/check.awk
curves = awk -v study=$(1) -v blank=all -v end=$(2) -f pipelines/must.awk -f pipelines/curve.awk
columns = awk -f pipelines/columns.awk

first: $(RESULTS)/first/curve.csv
	$(call curves,$@,0.04) $<
plate-cg: $(RESULTS)/plate-cg/curve.csv
	$(call must,$@,-v blank=all) $<
flagship: ni-cell
ni-cell: $(RESULTS)/ni-cell$(small)/curve.csv
	$(call must,$@,-v blank=all $(if $(SMALL),-v small=yes)) $<
hs40: $(RESULTS)/ni-hs40$(small)/curve.csv
	$(call curves,$@,$(if $(SMALL),0.01,0.30)) $<
r40: $(RESULTS)/ni-r40$(small)/curve.csv
	$(call curves,$@,$(if $(SMALL),0.01,0.30)) $<
thesis: $(RESULTS)/ni-hs40-thesis$(small)/curve.csv
	$(call curves,$@,$(if $(SMALL),0.01,0.25)) $<
errors: $(RESULTS)/errors/table.md $(if $(SMALL),,$(RESULTS)/errors/finite.csv)
	$(call must,$@,-v blank=all $(if $(SMALL),-v small=yes)) $(@:%=$(RESULTS)/%/elastic.csv) $(@:%=$(RESULTS)/%/plates.csv)
hs40-horizons: $(RESULTS)/ni-hs40/horizons.csv
hs40-rate: $(RESULTS)/ni-hs40/rate.csv
study: $(RESULTS)/study/figure.svg $(RESULTS)/study/table.csv

$(RESULTS)/%: SHELL := /bin/bash
$(RESULTS)/%: .SHELLFLAGS := -o pipefail -ec
$(RESULTS)/%: export PATH := $(abspath $(BUILD)/bin):$(PATH)

# The runs of a deck, by name: its folder in $(RESULTS), itself, the names, and lines for it, in quotes, that vary it.  What is beside the deck may be of
# it.  A run is made anew when its own deck is another.
# What decks wait for; tests, whose programs are there, empty it.
BUILT ?= all
define RUNS
DECKS += $(RESULTS)/$(1)/study.csv
$(RESULTS)/$(1)/study.csv: $(2) $(wildcard $(dir $(2))*.csv) pipelines/expand pipelines/csv.awk | $(BUILT)
	pipelines/expand $$< $$(@D) $(4)
$(3:%=$(RESULTS)/$(1)/%/deck.yaml): $(RESULTS)/$(1)/study.csv
	@test -e $$@ || { echo "$(2) has no such run: $$@" >&2; exit 1; }
endef
runs = $(eval $(call RUNS,$(1),$(or $(4),pipelines/$(1)/study.yaml),$(2),$(3)))

# Decks of one run, and the small forms of those that have one.
small_ni-hs40 := 'vary:\n  end: {name: [small], end_strain: [0.01]}\n'
small_ni-r40 := $(small_ni-hs40)
small_ni-hs40-thesis := $(small_ni-hs40)
small_ni-cell := 'vary:\n  form: {name: [small], spacing: [5 um], minimum_shell: [1 spacings], end_strain: [0.01]}\n'
LARGE := ni-cell ni-hs40 ni-r40 ni-hs40-thesis
PLAIN := first plate-cg $(if $(SMALL),,$(LARGE))
$(PLAIN:%=$(RESULTS)/%/deck.yaml): $(RESULTS)/%/deck.yaml: pipelines/%/study.yaml pipelines/expand
	pipelines/expand $< $(@D)
DECKS := $(PLAIN:%=$(RESULTS)/%/deck.yaml)
$(if $(SMALL),$(foreach s,$(LARGE),$(call runs,$(s),small,$(small_$(s)))))

CELLS := bcc fcc sc direction-bcc direction-fcc direction-sc jitter random interface large contrast-bcc contrast-random contrast-large size
cells: $(RESULTS)/cells/table.csv
	$(call must,$@,-v blank=all $(if $(SMALL),-v small=yes)) $<
$(RESULTS)/cells/table.csv: $(wildcard pipelines/cells/*) | all
	pipelines/cells/run $(@D) $(if $(SMALL),small)
	awk -f pipelines/cells/table.awk $(CELLS:%=$(@D)/%/study.csv) > $@
DECKS += $(RESULTS)/cells/decks
.PHONY: $(RESULTS)/cells/decks
$(RESULTS)/cells/decks:
	pipelines/cells/run $@ decks

map: $(RESULTS)/map/indices.csv
	$(call must,$@,-v blank=all $(if $(SMALL),-v small=yes)) $<
$(RESULTS)/map/indices.csv: $(wildcard pipelines/map/*) | all
	pipelines/map/run $(@D) $(if $(SMALL),40,1000)
	awk -v folder=$(@D)/runs -f pipelines/map/gather.awk $(@D)/runs/study.csv > $(@D)/map.csv
	awk -v factors=7 -v degree=$(if $(SMALL),1,3) -v names=arrangement -f pipelines/map/sobol.awk $(@D)/map.csv > $@
	gnuplot -c pipelines/map/figure.gp $@ $(@D)/map.svg
DECKS += $(RESULTS)/map/decks
.PHONY: $(RESULTS)/map/decks
$(RESULTS)/map/decks:
	pipelines/map/run $@ 1000 decks

# From a deck to everything.
define RUN
@mkdir -p $(@D)
hsgen $< --statistics $(@D)/statistics.csv --picture $(@D)/structure.png \
| hssolve -j $(RANKS) $(if $(FIELDS),--output $(@D)/fields.e) 2> >(tee $(@D)/hssolve.log >&2) \
| hspost --properties $(@D)/properties.csv --plot $(@D)/curve.svg > $@
endef
$(RESULTS)/%/curve.csv: $(RESULTS)/%/deck.yaml | all
	$(RUN)
$(patsubst %,$(RESULTS)/%$(small)/curve.csv,ni-hs40 ni-r40 ni-hs40-thesis): FIELDS := yes

# The README's pipe, to the letter.
$(RESULTS)/first/curve.csv: pipelines/first/study.yaml | all
	@mkdir -p $(@D)
	hsgen $< | hssolve -j $(RANKS) | hspost --plot $(@D)/curve.svg > $@

hs40_varied := 'vary:\n  test: {name: [horizon-2, horizon-3, half-speed], post.title: [HS40 at horizon 2, HS40 at horizon 3, HS40 at half the speed],\n    solver.horizon: [2, 3, 1], end_strain: [0.30, 0.30, 0.10],\n    boundary.1.velocity: [-10 m/s, -10 m/s, -5 m/s], boundary.2.velocity: [10 m/s, 10 m/s, 5 m/s]}\n'
$(call runs,ni-hs40-varied,horizon-2 horizon-3 half-speed,$(hs40_varied),pipelines/ni-hs40/study.yaml)
# Differences are those of the longer horizon against horizon 1, cost is what hssolve said at the end.
LONGER := $(foreach h,2 3,$(RESULTS)/ni-hs40-varied/horizon-$(h)/curve.csv)
HORIZONS := $(RESULTS)/ni-hs40/curve.csv $(LONGER)
$(RESULTS)/ni-hs40/horizons.csv: $(HORIZONS) pipelines/compare.awk
	hspost -q $(HORIZONS) --plot $(@D)/horizons.svg
	for curve in $(LONGER); do hspost -q --difference $$curve $< --strain-range 0.01:0.18; done > $(@D)/horizons-difference.csv
	grep ' steps in ' $(HORIZONS:curve.csv=hssolve.log) > $(@D)/horizons-cost.txt
	awk -f pipelines/compare.awk $(HORIZONS) > $@

# The faster against the slower.
RATES := $(RESULTS)/ni-hs40/curve.csv $(RESULTS)/ni-hs40-varied/half-speed/curve.csv
$(RESULTS)/ni-hs40/rate.csv: $(RATES)
	hspost -q $(RATES) --plot $(@D)/rate.svg
	hspost -q --difference $(RATES) --strain-range 0.01:0.1 > $@

# The study: the bodies of bodies.csv, all with one cell structure at both spacings.
SEEDS := $(if $(SMALL),2,2 5 9)
STUDY := $(foreach s,$(SPACINGS),$(foreach m,cg ufg hs40 $(SEEDS:%=r40-seed%),$(RESULTS)/study/$(m)-$(s)/curve.csv))
$(call runs,study,$(STUDY:$(RESULTS)/study/%/curve.csv=%))
BOUNDS = $(foreach s,$(SPACINGS),$(RESULTS)/study/voigt-$(s).csv $(RESULTS)/study/reuss-$(s).csv)

define STUDY_BOUNDS
$(RESULTS)/study/voigt-$(1).csv $(RESULTS)/study/reuss-$(1).csv &: $(RESULTS)/study/cg-$(1)/curve.csv $(RESULTS)/study/ufg-$(1)/curve.csv
	hspost -q $$^ --fraction 0.4 --strain-range 0:0.1 --voigt $$(RESULTS)/study/voigt-$(1).csv --reuss $$(RESULTS)/study/reuss-$(1).csv
endef
$(foreach s,$(SPACINGS),$(eval $(call STUDY_BOUNDS,$(s))))

$(RESULTS)/study/figure.svg: $(STUDY) $(BOUNDS) pipelines/study/figure.gp
	gnuplot -c pipelines/study/figure.gp $(@D) $@ $(SPACINGS)
$(RESULTS)/study/table.csv: $(STUDY) $(BOUNDS) pipelines/compare.awk
	awk -f pipelines/compare.awk $(STUDY) $(BOUNDS) > $@
	$(call curves,study,0.10) $(STUDY)

# Errors of the materials: elastic ones by a program of its own, yield and hardening by plates.
$(RESULTS)/errors/elastic.csv: $(BUILD)/tests/physics/errors
	@mkdir -p $(@D)
	$< > $@
PLATES := $(if $(SMALL),ordinary_plastic-linear-3.015-whole-none correspondence-constant-1-whole-none-mix,\
          $(shell awk -F, '!/^#|^name|^finite/ {print $$1}' pipelines/errors/plates.csv))
$(call runs,errors-plates,$(PLATES) finite,,pipelines/errors/plate.yaml)
$(RESULTS)/errors/plates.csv: $(RESULTS)/errors-plates/study.csv pipelines/errors/plates | all
	@mkdir -p $(@D)
	pipelines/errors/plates $(<D) $(PLATES) > $@
$(RESULTS)/errors/table.md: pipelines/errors/table.awk $(RESULTS)/errors/elastic.csv $(RESULTS)/errors/plates.csv
	awk -F, -f $^ > $@
$(RESULTS)/errors/finite.csv: $(RESULTS)/errors-plates/finite/curve.csv pipelines/errors/finite.awk
	$(columns) -F, -f pipelines/errors/finite.awk $< > $@

# Where stress varies: each case runs through formulations and spacings and writes rows.  What CalculiX gives comes from the folder;
# CALCULIX=yes makes it anew.  The table goes into docs/errors.md, between its marks.
TRUTHS := bending torsion laminate bar flow circles inclined limit block cell
TRUTHS_CALCULIX := $(if $(CALCULIX),$(RESULTS)/truths,pipelines/truths)/calculix.csv
truths: $(RESULTS)/truths/table.md
	$(if $(SMALL),,awk -f pipelines/truths/insert.awk $< docs/errors.md > $(<D)/errors.md && cp $(<D)/errors.md docs/errors.md)
	$(if $(SMALL),,awk -F, -f pipelines/truths/cost.awk $(<D)/table.csv > docs/bench/truths.md)
$(RESULTS)/truths/calculix.csv: $(wildcard pipelines/truths/*)
	@mkdir -p $(@D)
	pipelines/truths/calculix $(@D)/calculix > $@
$(TRUTHS:%=$(RESULTS)/truths/%.csv): $(RESULTS)/truths/%.csv: pipelines/truths/% $(wildcard pipelines/truths/*.bash pipelines/truths/[cs]*.awk) | all
	@mkdir -p $(@D)
	pipelines/truths/$* $(@D)/$* $(if $(SMALL),small) > $@
$(RESULTS)/truths/table.md: $(TRUTHS:%=$(RESULTS)/truths/%.csv) $(TRUTHS_CALCULIX) $(wildcard pipelines/truths/*.awk)
	awk -F, -v csv=$(@D)/table.csv -f pipelines/truths/table.awk $(filter %.csv,$^) > $@
	$(call must,truths,-v blank=cpu_s $(if $(SMALL),-v small=yes)) $(@D)/table.csv
DECKS += $(RESULTS)/truths/decks
.PHONY: $(RESULTS)/truths/decks
$(RESULTS)/truths/decks:
	for case in $(TRUTHS); do pipelines/truths/$$case $@/$$case decks || exit 1; done

# The bond-based sheet: a test for each plane, horizon, spacing, kind of volumes and of surface
# correction; its folder has that name.  Plane strain differs by a factor, so one spacing and horizon do.
BOND_HORIZONS := $(if $(SMALL),3.015,2.015 3.015 4.015 5.015)
BOND_KINDS := whole-none whole-energy partial-none partial-energy
BOND_NAMES := $(foreach k,$(BOND_KINDS),$(foreach h,$(BOND_HORIZONS),$(foreach s,4mm 2mm 1mm,stress-$(h)-$(s)-$(k))) strain-3.015-2mm-$(k))
BOND_PLATES := $(BOND_NAMES:%=$(RESULTS)/bond-plate/%)
bond-plate: $(RESULTS)/bond-plate/figure.svg

$(call runs,bond-plate,$(BOND_NAMES))
$(BOND_PLATES:%=%/curve.csv): FIELDS := yes
$(BOND_PLATES:%=%/row.csv): %/row.csv: %/curve.csv pipelines/bond-plate/measure.awk
	hspost --frames $(@D)/fields.e --csv --variables DisplacementX,DisplacementY > $(@D)/displacement.csv
	$(columns) -v name=$(notdir $(@D)) -f pipelines/bond-plate/measure.awk $< $(@D)/displacement.csv > $@
$(RESULTS)/bond-plate/table.csv: $(BOND_PLATES:%=%/row.csv) pipelines/bond-plate/check.awk
	{ echo plane,horizon,spacing_mm,volumes,surface_correction,exact_GPa,measured_GPa,error_percent,lattice_error_percent,poissons_ratio,lattice_poissons_ratio; \
	cat $(filter %.csv,$^); } > $@
	$(call must,bond-plate,-v rows=$(words $(BOND_PLATES)) $(if $(SMALL),-v small=yes)) $@
$(RESULTS)/bond-plate/figure.svg: $(RESULTS)/bond-plate/table.csv pipelines/bond-plate/figure.gp
	gnuplot -c pipelines/bond-plate/figure.gp $< $@

# The plate loaded in steps: the study, the same with 30 MPa a step, and as the report computed it (README);
# the plate at rest for two models and spacings.  These have no grips, hence no curve.
define FRAMES
@mkdir -p $(@D)
hsgen $< --statistics $(@D)/statistics.csv | hssolve -j $(RANKS) -o $@ -H $(@D)/history.e 2> >(tee $(@D)/hssolve.log >&2)
endef
LOADS := study strong report
HELD := $(foreach m,madenci_oterkus ordinary,$(m)-2mm $(m)-1mm)
load-steps: $(LOADS:%=$(RESULTS)/load-steps/%/frames.png) $(RESULTS)/load-steps/table.csv

$(call runs,load-steps,$(LOADS))
$(call runs,load-steps/held,$(HELD),,pipelines/load-steps/held.yaml)
$(RESULTS)/load-steps/%/fields.e: $(RESULTS)/load-steps/%/deck.yaml | all
	$(FRAMES)
$(RESULTS)/load-steps/%/frames.png: $(RESULTS)/load-steps/%/fields.e
	for frame in 2 3 4 5 6 7; do hspost --frames $< --frame $$frame --picture $(@D)/step-$$(((frame - 1) * 250)).png \
	--variables Displacement,ExternalForceX,ForceX,Damage; done
	touch $@
$(RESULTS)/load-steps/%/displacement.csv: $(RESULTS)/load-steps/%/fields.e
	hspost --frames $< --csv --variables DisplacementX,DisplacementY > $@
$(RESULTS)/load-steps/table.csv: $(HELD:%=$(RESULTS)/load-steps/held/%/displacement.csv) $(LOADS:%=$(RESULTS)/load-steps/%/fields.e) $(wildcard pipelines/load-steps/*.awk)
	{ echo model,spacing,strain,poissons_ratio,end_displacement_mm,strain_error_percent,poissons_ratio_error_percent,end_displacement_error_percent; \
	for name in $(HELD); do $(columns) -v name=$$name -f pipelines/load-steps/measure.awk $(@D)/held/$$name/displacement.csv; done; } > $@
	{ echo deck,frame,load_N,most_damage,damage_left,damage_right; for name in $(LOADS); do for frame in 2 3 4 5 6 7; do \
	hspost --frames $(@D)/$$name/fields.e --frame $$frame --csv --variables ExternalForceX,Damage \
	| awk -F, -v name=$$name,$$frame '/^[#x]/ {next} $$5 > most {most = $$5} $$1 > 0 {load += $$4*12e-9; right += $$5} $$1 < 0 {left += $$5} \
	END {printf "%s,%.9g,%.4f,%.12g,%.12g\n", name, load, most, left, right}'; done; done; } > $(@D)/loads.csv
	$(call must,load-steps,-v rows=$(words $(HELD) $(foreach l,$(LOADS),2 3 4 5 6 7))) $@ $(@D)/loads.csv

# The crack in a glass plate at two spacings: its tip through the frames, pictures.
CRACKS := 1mm$(if $(SMALL),, 0.5mm)
$(call runs,crack,$(CRACKS))
crack: $(RESULTS)/crack/figure.svg $(RESULTS)/crack/table.csv $(CRACKS:%=$(RESULTS)/crack/%/pictures)
$(CRACKS:%=$(RESULTS)/crack/%/fields.e): %/fields.e: %/deck.yaml | all
	$(FRAMES)
$(RESULTS)/crack/track-%.csv: $(RESULTS)/crack/%/fields.e pipelines/crack/track.awk
	for frame in $$(hspost --frames $< | awk -F, '/^[0-9]/ {print $$1}'); do \
	hspost --frames $< --frame $$frame --csv --variables Damage --slice z; done \
	| $(columns) -v spacing=$(*:mm=) -f pipelines/crack/track.awk > $@
$(RESULTS)/crack/table.csv: $(CRACKS:%=$(RESULTS)/crack/track-%.csv) pipelines/crack/check.awk
	$(call must,crack,-v blank="tip_mm branching_mm" $(if $(SMALL),-v small=yes)) $(filter %.csv,$^) > $@ || { cat $@ >&2; exit 1; }
$(RESULTS)/crack/figure.svg: $(CRACKS:%=$(RESULTS)/crack/track-%.csv) pipelines/crack/figure.gp
	gnuplot -c pipelines/crack/figure.gp $(@D) $@
$(RESULTS)/crack/%/pictures: $(RESULTS)/crack/%/fields.e
	for time in 15 25 35 45; do hspost --frames $< --time "$$time us" --picture $(@D)/damage-$$time-us.png --variables Damage --slice z --range 0:0.6; done
	touch $@

# G of a crack in a long strip with clamped edges, slow and running.
strip: $(RESULTS)/strip/table.csv
DECKS += $(RESULTS)/strip/decks
.PHONY: $(RESULTS)/strip/decks
$(RESULTS)/strip/decks:
	pipelines/strip/strips $@ decks
$(RESULTS)/strip/table.csv: $(wildcard pipelines/strip/*.awk) pipelines/strip/strips | all
	@mkdir -p $(@D)
	pipelines/strip/strips $(@D)/runs $(if $(SMALL),small) > $@
	$(call must,strip,-v blank="first slow released broken running of_bonds speed") $@

# The thesis' explicit runs at both velocities, with its plasticity and without.
IMPACTS := $(if $(SMALL),,plastic-450 plastic-45) elastic-450 elastic-45
$(call runs,thesis-impact,$(IMPACTS))
thesis-impact: $(RESULTS)/thesis-impact/table.csv $(IMPACTS:%=$(RESULTS)/thesis-impact/%/pictures)
$(IMPACTS:%=$(RESULTS)/thesis-impact/%/curve.csv): FIELDS := yes
# The wave is where half the velocity of the grips is; the front of the plastic one at 2 m/s.
$(RESULTS)/thesis-impact/%/frames.csv: $(RESULTS)/thesis-impact/%/curve.csv pipelines/thesis-impact/frames.awk
	for frame in $$(hspost --frames $(@D)/fields.e | awk -F, '/^[0-9]/ {print $$1}'); do \
	hspost --frames $(@D)/fields.e --frame $$frame --csv --variables Damage,VelocityX --slice z; done \
	| $(columns) -v level=$(if $(filter elastic,$(subst -, ,$*)),$(if $(filter 45,$(subst -, ,$*)),22.5,225),2) -f pipelines/thesis-impact/frames.awk > $@
$(RESULTS)/thesis-impact/table.csv: $(IMPACTS:%=$(RESULTS)/thesis-impact/%/frames.csv) $(wildcard pipelines/thesis-impact/*.awk)
	{ echo material,velocity_m_per_s,step_s,steps,wave_m_per_s,at_the_middle_ns,middle_broken_ns,ends_broken_ns; \
	for name in $(IMPACTS); do awk -v name=$$name -f pipelines/thesis-impact/measure.awk $(@D)/$$name/curve.csv $(@D)/$$name/frames.csv; done; } > $@
	$(call must,thesis-impact,-v rows=$(words $(IMPACTS)) -v blank="middle_broken_ns ends_broken_ns" $(if $(SMALL),-v small=yes)) $@
$(RESULTS)/thesis-impact/%/pictures: $(RESULTS)/thesis-impact/%/curve.csv
	for time in 400 550 700 1100; do hspost --frames $(@D)/fields.e --time "$$time ns" --picture $(@D)/at-$$time-ns.png \
	--variables VelocityX,Damage --slice z --deformed 1; done
	touch $@

# The thesis' boundary conditions: one plate, four sections `boundary`.
HOLDS := 1 2 3 4
$(call runs,thesis-boundary,$(HOLDS),,pipelines/thesis-boundary/plate.yaml)
thesis-boundary: $(RESULTS)/thesis-boundary/table.csv $(HOLDS:%=$(RESULTS)/thesis-boundary/%/strain.png)
$(HOLDS:%=$(RESULTS)/thesis-boundary/%/fields.e): %/fields.e: %/deck.yaml | all
	$(FRAMES)
$(HOLDS:%=$(RESULTS)/thesis-boundary/%/nodes.csv): %/nodes.csv: %/fields.e
	hspost --frames $< --csv --variables EquivalentPlasticStrain,VonMises > $@
$(HOLDS:%=$(RESULTS)/thesis-boundary/%/strain.png): %/strain.png: %/fields.e
	hspost --frames $< --picture $@ --variables EquivalentPlasticStrain --deformed 3 --range 0:0.08
$(RESULTS)/thesis-boundary/table.csv: $(HOLDS:%=$(RESULTS)/thesis-boundary/%/nodes.csv) $(wildcard pipelines/thesis-boundary/*.awk)
	{ echo variant,mean_percent,most_percent,mean_von_mises_MPa,asymmetry_x_percent,asymmetry_y_percent,asymmetry_turned_percent; \
	for name in $(HOLDS); do $(columns) -v name=$$name -f pipelines/thesis-boundary/measure.awk $(@D)/$$name/nodes.csv; done; } > $@
	$(call must,thesis-boundary,-v rows=$(words $(HOLDS))) $@

# Bars that part: phase, whether the interval of damage is scaled by a length, m/s of a grip, and spacing in um.
PARTING := $(foreach m,cg$(if $(SMALL),, ufg),$(foreach v,25$(if $(SMALL),, 5),$(foreach s,25 16.7 12.5,$(foreach k,local length,$(m)-$(k)-$(v)-$(s)))))
$(call runs,fracture-spacing,$(PARTING))
fracture-spacing: $(RESULTS)/fracture-spacing/table.csv $(if $(SMALL),,$(RESULTS)/fracture-spacing/figure.svg)
$(RESULTS)/fracture-spacing/%/columns.csv: $(RESULTS)/fracture-spacing/%/deck.yaml | all
	hsgen $< | hssolve -j $(RANKS) 2> >(tee $(@D)/hssolve.log >&2) | hspost --columns > $@
$(RESULTS)/fracture-spacing/table.csv: $(PARTING:%=$(RESULTS)/fracture-spacing/%/columns.csv) $(wildcard pipelines/fracture-spacing/*.awk)
	{ echo phase,velocity_m_per_s,spacing_um,damage,peak_MPa,first_damage_strain,fracture_strain,opening_um,dissipated_mJ,dissipated_after_peak_mJ,damaged_um,removed_nodes,drift; \
	for name in $(PARTING); do $(columns) -v name=$$name -f pipelines/fracture-spacing/measure.awk $(@D)/$$name/columns.csv; done; } > $@
	$(call must,fracture-spacing,-v rows=$(words $(PARTING))) $@
$(RESULTS)/fracture-spacing/figure.svg: $(RESULTS)/fracture-spacing/table.csv pipelines/fracture-spacing/figure.gp
	gnuplot -c pipelines/fracture-spacing/figure.gp $(@D) $@

# Runs of which the history is all that counts.
define HISTORY
@mkdir -p $(@D)
hsgen -q $< | hssolve -j $(RANKS) -H $@ 2> >(tee $(@D)/hssolve.log >&2)
endef

# Bars that neck: laws, horizons, spacings, the other stabilisation.
NECKS := $(if $(SMALL),cg ufg linear,cg cg-16um cg-12um cg-horizon2 cg-horizon3 cg-capped ufg linear power)
$(call runs,necking,$(NECKS))
necking: $(RESULTS)/necking/table.csv
exact_cg := -v law=voce -v a=182.1 -v b=513.0 -v c=5.320
exact_ufg := -v law=voce -v a=1259.8 -v b=564.5 -v c=238.5
exact_linear := -v law=linear -v a=185 -v b=898
exact_power := -v law=swift -v a=300 -v b=4356 -v c=0.302
$(NECKS:%=$(RESULTS)/necking/%/history.e): %/history.e: %/deck.yaml | all
	$(HISTORY)
$(NECKS:%=$(RESULTS)/necking/%/row.csv): $(RESULTS)/necking/%/row.csv: $(RESULTS)/necking/%/history.e pipelines/necking/measure.awk
	hspost -q --columns $< | $(columns) -v name=$* -v section=0.04 $(exact_$(firstword $(subst -, ,$*))) -f pipelines/necking/measure.awk > $@
$(RESULTS)/necking/table.csv: $(NECKS:%=$(RESULTS)/necking/%/row.csv) pipelines/necking/check.awk
	{ echo bar,largest_stress_MPa,strain_there,considere_MPa,considere_strain,stress_error_percent,strain_error_percent,end_strain,load_left,section_ratio,largest_plastic_strain,force_evaluations; \
	cat $(filter %.csv,$^); } > $@
	$(call must,necking,-v rows=$(words $(NECKS))) $@

# The necking bar of Simo and Hughes: an eighth of a round bar between its planes of symmetry.  CalculiX' half comes from the folder; CALCULIX=yes makes it anew.
BARS := 3-150 6-150 6-150-soft $(if $(SMALL),,6-25 6-50 6-150-four_points 12-150 12-150-soft 12-300 12-300-soft)
BAR_STORED := $(if $(CALCULIX),$(RESULTS),pipelines)/necking-bar/calculix.csv
$(call runs,necking-bar,$(BARS))
necking-bar: $(RESULTS)/necking-bar/table.csv
$(BARS:%=$(RESULTS)/necking-bar/%/history.e): %/history.e: %/deck.yaml | all
	hsgen -q $< -o $(@D)/whole.g --peridigm $(@D)/whole
	awk '/^#/ || $$1 > 0 && $$2 > 0 && $$3 > 0' $(@D)/whole.txt > $(@D)/eighth.txt
	TIMEFORMAT=%U; { time hssolve -q -j 1 -d $< -i $(@D)/eighth.txt -H $@; } 2> $(@D)/seconds
$(BARS:%=$(RESULTS)/necking-bar/%/row.csv): $(RESULTS)/necking-bar/%/row.csv: $(RESULTS)/necking-bar/%/history.e $(BAR_STORED) pipelines/necking-bar/measure.awk
	hspost -q --columns $< | $(columns) -F, -v name=$* -v particles=$$(grep -vc '^#' $(@D)/eighth.txt) -v cpu=$$(tail -n 1 $(@D)/seconds) \
	-f pipelines/necking-bar/measure.awk $(BAR_STORED) - > $@
$(RESULTS)/necking-bar/calculix.csv: $(addprefix pipelines/necking-bar/,calculix mesh.awk curve.awk)
	@mkdir -p $(@D)
	pipelines/necking-bar/calculix $(@D)/calculix > $@
$(RESULTS)/necking-bar/table.csv: $(BARS:%=$(RESULTS)/necking-bar/%/row.csv) $(BAR_STORED) pipelines/necking-bar/check.awk
	{ echo bar,particles,largest_kN,at_mm,error_1_mm,error_2_mm,error_3_mm,error_4_mm,error_5_mm,error_6_mm,error_6.5_mm,error_7_mm,radius_5_mm,radius_6_mm,radius_6.5_mm,radius_7_mm,largest_plastic_strain,forces,cpu_s; \
	cat $(filter %/row.csv,$^); \
	for mesh in $$(cut -d, -f1 $(BAR_STORED) | grep / | uniq); do $(columns) -F, -v mesh=$$mesh -f pipelines/necking-bar/measure.awk $(BAR_STORED); done; } > $@
	$(call must,necking-bar,-v blank="particles forces" $(if $(SMALL),-v small=yes)) $@

# Taylor's bar: a quarter of a round bar that strikes a plane of symmetry.
TAYLORS := 3-30 6-60 $(if $(SMALL),,6-120 12-120)
$(call runs,taylor-bar,$(TAYLORS))
taylor-bar: $(RESULTS)/taylor-bar/table.csv
$(TAYLORS:%=$(RESULTS)/taylor-bar/%/history.e): %/history.e: %/deck.yaml | all
	hsgen -q $< -o $(@D)/whole.g --peridigm $(@D)/whole
	awk '/^#/ || $$2 > 0 && $$3 > 0' $(@D)/whole.txt > $(@D)/quarter.txt
	TIMEFORMAT=%U; { time hssolve -q -j 1 -d $< -i $(@D)/quarter.txt -H $@ -o $(@D)/fields.e; } 2> $(@D)/seconds
$(TAYLORS:%=$(RESULTS)/taylor-bar/%/row.csv): $(RESULTS)/taylor-bar/%/row.csv: $(RESULTS)/taylor-bar/%/history.e pipelines/taylor-bar/measure.awk
	hspost -q --columns $< > $(@D)/history.csv
	hspost --frames $(@D)/fields.e --csv > $(@D)/nodes.csv
	$(columns) -F, -v name=$* -v cpu=$$(tail -n 1 $(@D)/seconds) -f pipelines/taylor-bar/measure.awk $(@D)/history.csv $(@D)/nodes.csv > $@
$(RESULTS)/taylor-bar/table.csv: $(TAYLORS:%=$(RESULTS)/taylor-bar/%/row.csv) pipelines/taylor-bar/check.awk
	{ echo bar,particles,length_mm,foot_mm,largest_plastic_strain,least_push_kN,kinetic_percent,drift_percent,forces,cpu_s; cat $(filter %.csv,$^); } > $@
	$(call must,taylor-bar,-v rows=$(words $(TAYLORS))) $@

# CG, UFG, HS40 and R40 pulled apart.
BREAKS := cg ufg hs40 r40
$(call runs,fracture,$(BREAKS))
fracture: $(RESULTS)/fracture/table.csv $(RESULTS)/fracture/figure.svg $(BREAKS:%=$(RESULTS)/fracture/%/broken.png)
$(BREAKS:%=$(RESULTS)/fracture/%/fields.e): %/fields.e: %/deck.yaml | all
	$(FRAMES)
$(BREAKS:%=$(RESULTS)/fracture/%/curve.csv): %/curve.csv: %/fields.e
	hspost $(@D)/history.e -p $(@D)/properties.csv --plot $(@D)/curve.svg > $@
$(BREAKS:%=$(RESULTS)/fracture/%/row.csv): $(RESULTS)/fracture/%/row.csv: $(RESULTS)/fracture/%/fields.e pipelines/fracture/measure.awk pipelines/fracture/starts.awk
	hspost -q --columns $(@D)/history.e | $(columns) -v name=$* -f pipelines/fracture/measure.awk > $(@D)/numbers.csv
	for frame in $$(hspost --frames $< | awk -F, '/^[0-9]/ {print $$1}'); do hspost --frames $< --frame $$frame --csv --variables Damage,Phase; done \
	| $(columns) -f pipelines/fracture/starts.awk | paste -d, $(@D)/numbers.csv - > $@
$(RESULTS)/fracture/table.csv: $(BREAKS:%=$(RESULTS)/fracture/%/row.csv) pipelines/fracture/check.awk
	{ echo bar,Rm_MPa,strain_at_Rm,strain_broken,grip_strain_broken,work_MJ_per_m3,grips_apart_until_Rm_percent,grips_apart_percent,nodes_gone,energy_drift,forces_at_rest,forces_in_motion,first_gone,first_gone_x_mm,first_gone_ufg_share,first_degraded_phase; \
	cat $(filter %.csv,$^); } > $@
	$(call must,fracture,-v rows=$(words $(BREAKS))) $@
$(RESULTS)/fracture/figure.svg: $(BREAKS:%=$(RESULTS)/fracture/%/curve.csv) pipelines/fracture/figure.gp
	gnuplot -c pipelines/fracture/figure.gp $(@D) $@
$(RESULTS)/fracture/%/broken.png: $(RESULTS)/fracture/%/fields.e
	hspost --frames $< --frame last --picture $@ --variables EquivalentPlasticStrain,Damage,Phase --slice z --deformed 1

# The same plate by load steps, explicit steps, and both.
SWITCHES := static-0.001 static-0.005 static-0.01 hybrid explicit-10 explicit-4 explicit-2
$(call runs,solver-switch,$(SWITCHES))
solver-switch: $(RESULTS)/solver-switch/table.csv
$(SWITCHES:%=$(RESULTS)/solver-switch/%/history.e): %/history.e: %/deck.yaml | all
	hsgen -q $< -o $(@D)/domain.g
	{ time -p hssolve -i $(@D)/domain.g -H $@; } 2> $(@D)/time
$(SWITCHES:%=$(RESULTS)/solver-switch/%/curve.csv): %/curve.csv: %/history.e
	hspost -q $< > $@
$(RESULTS)/solver-switch/table.csv: $(SWITCHES:%=$(RESULTS)/solver-switch/%/curve.csv) $(wildcard pipelines/solver-switch/*.awk)
	{ echo run,mean_deviation_percent,largest_deviation_percent,at_half_a_percent,at_two_percent,force_evaluations,cpu_s; \
	for name in $(SWITCHES); do $(columns) -v name=$$name -f pipelines/solver-switch/measure.awk $(@D)/static-0.001/curve.csv $(@D)/$$name/curve.csv $(@D)/$$name/time; done; } > $@
	$(call must,solver-switch,-v rows=$(words $(SWITCHES))) $@

# Waves: three decks that vary, their tables, a figure.
waves: $(RESULTS)/waves/figure.svg
DECKS += $(RESULTS)/waves/decks
.PHONY: $(RESULTS)/waves/decks
$(RESULTS)/waves/decks:
	pipelines/waves/run $@ decks
$(RESULTS)/waves/fronts.csv: $(wildcard pipelines/waves/*) | all
	pipelines/waves/run $(@D) $(if $(SMALL),small)
$(RESULTS)/waves/figure.svg: $(RESULTS)/waves/fronts.csv
	$(call must,waves,-v blank=all) $(addprefix $(@D)/,lattice.csv bars-table.csv pulses.csv) $<
	gnuplot -c pipelines/waves/figure.gp $(@D) $@

# What load steps cost.
solvers: $(RESULTS)/solvers/table.md
$(RESULTS)/solvers/runs.csv: $(addprefix pipelines/solvers/,run cg.yaml hs40.yaml) | all
	@mkdir -p $(@D)
	pipelines/solvers/run $(@D) $(if $(SMALL),small) > $@
DECKS += $(RESULTS)/solvers/decks
.PHONY: $(RESULTS)/solvers/decks
$(RESULTS)/solvers/decks:
	pipelines/solvers/run $(@D) decks
$(RESULTS)/solvers/table.md: $(RESULTS)/solvers/runs.csv $(wildcard pipelines/solvers/*.awk)
	awk -F, -f pipelines/solvers/table.awk $< > $@
	$(call must,solvers,$(if $(SMALL),-v small=yes)) $<

# A bar of CG by explicit steps of many kinds, against the exact curve.
RATES_OF := static hybrid explicit-5 explicit-10 explicit-20 explicit-40 ramp-5 mass-10 mass-100 mass-1000 viscous-1e6 viscous-1e7 local-0.2 local-0.5 local-0.8
$(call runs,rates,$(RATES_OF))
rates: $(RESULTS)/rates/table.csv
$(RATES_OF:%=$(RESULTS)/rates/%/history.e): %/history.e: %/deck.yaml | all
	hsgen -q $< -o $(@D)/domain.g
	{ time -p hssolve -i $(@D)/domain.g -H $@; } 2> $(@D)/log
$(RATES_OF:%=$(RESULTS)/rates/%/row.csv): $(RESULTS)/rates/%/row.csv: $(RESULTS)/rates/%/history.e pipelines/rates/measure.awk
	hspost -q --columns $< | $(columns) -v name=$* -f pipelines/rates/measure.awk - $(@D)/log > $@
$(RESULTS)/rates/table.csv: $(RATES_OF:%=$(RESULTS)/rates/%/row.csv) pipelines/rates/check.awk
	{ echo run,E_error_percent,stress_error_at_1_percent,at_2_percent,at_5_percent,at_10_percent,largest_kinetic_percent,forces,cpu_s; \
	cat $(filter %.csv,$^); } > $@
	$(call must,rates,-v rows=$(words $(RATES_OF)) -v blank=E_error_percent) $@

# A harmonic structure by hssolve and by CalculiX on the same voxels, split along each axis.  The curves of CalculiX
# come from the folder; CALCULIX=yes makes them anew.
FE := $(RESULTS)/finite-elements
FE_SPLITS := 1 2$(if $(SMALL),, 3 4)
$(call runs,finite-elements,$(FE_SPLITS:%=hstools-%))
FE_RUNS := C3D8-1-0.04 C3D8I-1-0.04 C3D8I-2-0.04 C3D20R-1-0.08 C3D20R-2-0.08
FE_UNIFORM := C3D8I-1-0.08 C3D20R-1-0.08
FE_STORED := $(if $(CALCULIX),$(FE),pipelines/finite-elements)
fe_um = $(word $(1),25 12.5 8.3333333333333 6.25)
finite-elements: $(FE)/table.csv
	@command -v ccx > /dev/null || echo "finite-elements: CalculiX' half is that of pipelines/finite-elements: anew it needs ccx"

$(FE)/voxels.txt: $(FE)/hstools-1/deck.yaml | all
	@mkdir -p $(@D)
	hsgen $< -o $(@D)/domain.g --statistics $(@D)/statistics.csv --picture $(@D)/structure.png --peridigm $(@D)/voxels
define FE_HSTOOLS
$(FE)/hstools-$(1).csv: $(FE)/hstools-$(1)/deck.yaml $(FE)/voxels.txt pipelines/finite-elements/split.awk pipelines/finite-elements/hstools.awk
	awk -v by=$(1) -v spacing=25e-6 -f pipelines/finite-elements/split.awk $(FE)/voxels.txt > $(FE)/voxels-$(1).txt
	TIMEFORMAT=%U; { time hssolve -d $$< -i $(FE)/voxels-$(1).txt -H $(FE)/hstools-$(1).e 2> >(tee $(FE)/hssolve-$(1).log >&2); } 2> $(FE)/hstools-$(1).cpu
	hspost --columns $(FE)/hstools-$(1).e | $(columns) -F, -v spacing=$(call fe_um,$(1)) -v cpu=$$$$(tail -n 1 $(FE)/hstools-$(1).cpu) -f pipelines/finite-elements/hstools.awk > $$@
endef
$(foreach s,$(FE_SPLITS),$(eval $(call FE_HSTOOLS,$(s))))

# A name says element, split and load step; `uniform` is a bar of one phase.
$(FE_RUNS:%=$(FE)/%/curve.csv): $(FE)/%/curve.csv: $(FE)/voxels.txt $(addprefix pipelines/finite-elements/,calculix split.awk mesh.awk curve.awk)
	pipelines/finite-elements/calculix $(@D) $< $(word 2,$(subst -, ,$*)) $(word 1,$(subst -, ,$*)) $(word 3,$(subst -, ,$*))
$(FE_UNIFORM:%=$(FE)/uniform-%/curve.csv): $(FE)/uniform-%/curve.csv: $(FE)/voxels.txt $(addprefix pipelines/finite-elements/,calculix split.awk mesh.awk curve.awk)
	pipelines/finite-elements/calculix $(@D) $< $(word 2,$(subst -, ,$*)) $(word 1,$(subst -, ,$*)) $(word 3,$(subst -, ,$*)) uniform
$(FE)/calculix.csv: $(FE_RUNS:%=$(FE)/%/curve.csv) $(FE_UNIFORM:%=$(FE)/uniform-%/curve.csv)
	{ { ccx -v || true; } | awk 'NF {print "# CalculiX: " $$0}'; cksum < $(FE)/voxels.txt | awk '{print "# voxels: cksum " $$1}'; \
	echo method,spacing_um,engineering_strain,engineering_stress_MPa,cpu_s; \
	$(foreach r,$(FE_RUNS) $(FE_UNIFORM:%=uniform-%),awk -F, -v run=$(r) -v um=$(call fe_um,$(word 2,$(subst -, ,$(r:uniform-%=%)))) -v cpu=$$(cat $(FE)/$(r)/cpu.txt) \
	'$$1 + 0 > 0 {sub(/-[1-9]-.*/, "", run); printf "%s,%s,%s,%s,%s\n", run, um, $$1, $$2, cpu}' $(FE)/$(r)/curve.csv;) } > $@
$(FE)/table.csv: $(FE_SPLITS:%=$(FE)/hstools-%.csv) $(FE_STORED)/calculix.csv pipelines/finite-elements/table.awk pipelines/finite-elements/check.awk
	awk -F, -f pipelines/finite-elements/table.awk $(FE_STORED)/calculix.csv $(FE_SPLITS:%=$(FE)/hstools-%.csv) > $@
	$(call must,finite-elements,-v voxels=$$(cksum < $(FE)/voxels.txt | cut -d' ' -f1) -v blank=stress_5_MPa $(if $(SMALL),-v small=yes)) $(FE_STORED)/calculix.csv $@

# Unloading and reloading.  CalculiX has the programme of HS40 from programme.awk: strains to which, and strains by which it is unloaded.
LOOPED := $(if $(SMALL),cg hs40,cg ufg hs40 r40-1 r40-2 r40-3)
$(call runs,loops,$(LOOPED))
loops: $(RESULTS)/loops/table.csv
loops_to := 0.005 0.01 0.02 0.03 0.04
loops_down := 0.0017 0.0026 0.0034 0.004
$(LOOPED:%=$(RESULTS)/loops/%/history.e): %/history.e: %/deck.yaml | all
	hsgen -q $< | hssolve -q -j $(RANKS) -H $@
LOOPS_STORED := $(if $(CALCULIX),$(RESULTS),pipelines)/loops/calculix.csv
$(RESULTS)/loops/calculix.csv: $(FE)/voxels.txt $(addprefix pipelines/,loops/programme.awk loops/calculix.awk finite-elements/mesh.awk finite-elements/split.awk finite-elements/curve.awk)
	@mkdir -p $(@D)/calculix
	awk -v by=1 -v spacing=25e-6 -f pipelines/finite-elements/split.awk $< | \
	awk -v element=C3D8I -v spacing=25e-6 -v weights=$(@D)/calculix/weights.txt -f pipelines/finite-elements/mesh.awk > $(@D)/calculix/mesh.inp
	awk -v to="$(loops_to)" -v down="$(loops_down)" -f pipelines/loops/programme.awk > $(@D)/calculix/amplitude
	awk -v to="$(loops_to)" -f pipelines/loops/calculix.awk $(@D)/calculix/amplitude $(@D)/calculix/mesh.inp > $(@D)/calculix/bar.inp
	cd $(@D)/calculix && OMP_NUM_THREADS=1 ccx bar > ccx.log && tail -n 1 bar.sta | awk '$$7 < 8.99 {exit 1}'
	{ echo '# title: HS40 by CalculiX'; awk -f pipelines/finite-elements/curve.awk $(@D)/calculix/weights.txt $(@D)/calculix/bar.dat | cut -d, -f1,2; } > $@
# A periodic cell by the deck's own programme, and the eighth of it that its planes of symmetry leave, by CalculiX.
CELL_STORED := $(if $(CALCULIX),$(RESULTS),pipelines)/loops/calculix-cell.csv
$(RESULTS)/loops/cell/history.e: pipelines/loops/cell.yaml | all
	@mkdir -p $(@D)
	hsgen -q $< | hssolve -q -j $(RANKS) -H $@ $(if $(CALCULIX),-o $(@D)/particles.e)
$(RESULTS)/loops/calculix-cell.csv: $(RESULTS)/loops/cell/history.e pipelines/loops/cell.awk
	@mkdir -p $(@D)/calculix
	hspost --frames $(<D)/particles.e --csv --variables Phase -o $(<D)/particles.csv
	awk -F, -v spacing=6.666666666666667 -v cells=12 -v turns="$$(hspost -q $< | awk -F, -v turns=yes -f pipelines/loops/cell-curve.awk)" \
	-f pipelines/loops/cell.awk $(<D)/particles.csv > $(@D)/calculix/cell.inp
	cd $(@D)/calculix && OMP_NUM_THREADS=1 ccx cell > cell.log && tail -n 1 cell.sta | awk '$$7 < 9.99 {exit 1}'
	{ echo '# title: Cell by CalculiX'; awk -v edge=0.08 -f pipelines/loops/cell-curve.awk $(@D)/calculix/cell.dat; } > $@
$(RESULTS)/loops/table.csv: $(LOOPED:%=$(RESULTS)/loops/%/history.e) $(RESULTS)/loops/cell/history.e $(LOOPS_STORED) $(CELL_STORED) pipelines/loops/check.awk
	hspost -q $(filter %.e,$^) $(LOOPS_STORED) $(CELL_STORED) --loops $@ $(if $(SMALL),,--plot-loops $(@D)/figure.svg --plot $(@D)/curves.svg)
	$(call must,loops,-v blank=all $(if $(SMALL),-v small=yes)) $@

# One harmonic geometry at three spacings, by load steps to 10 %.
FINER := 25um 12.5um$(if $(SMALL),, 8.33um)
$(call runs,spacings,$(FINER))
spacings: $(RESULTS)/spacings/table.csv
$(RESULTS)/spacings/table.csv: $(FINER:%=$(RESULTS)/spacings/%/curve.csv) $(wildcard pipelines/spacings/*.awk)
	$(columns) -v names="$(FINER)" -f pipelines/spacings/table.awk $(filter %.csv,$^) > $@
	$(call must,spacings) $@

# The calibrations of the thesis (table 5), row by row.
ROWS := 01 02 03 04 05 06 07 08 09 10 11 12 13 14 14-whole 15 15-whole 18 19 20
MEASURED := $(ROWS) plates/16 plates/17 # the last two: a harmonic plate in place of the specimen
$(call runs,thesis-calibration,$(ROWS))
$(call runs,thesis-calibration/plates,16 17,,pipelines/thesis-calibration/plates.yaml)
thesis-calibration: $(RESULTS)/thesis-calibration/table.csv
$(MEASURED:%=$(RESULTS)/thesis-calibration/%/history.e): %/history.e: %/deck.yaml | all
	$(HISTORY)
$(RESULTS)/thesis-calibration/table.csv: $(MEASURED:%=$(RESULTS)/thesis-calibration/%/history.e) $(wildcard pipelines/thesis-calibration/*.awk)
	{ echo row,largest_stress_MPa,strain_there,broken,strain_at_the_end,broken_bonds,energy_drift; for name in $(MEASURED); do \
	hspost -q --columns $(@D)/$$name/history.e | $(columns) -v name=$${name#plates/} -f pipelines/thesis-calibration/measure.awk; done; } > $@
	$(call must,thesis-calibration,-v rows=$(words $(MEASURED))) $@

# The decks of all studies, and of the runs of `make bench`.
decks: $(DECKS)
	tests/bench/runs $(RESULTS)/bench/runs decks
	tests/bench/error $(RESULTS)/bench/error decks

studies: all
	pipelines/studies $(BUILD) $(RANKS) $(STUDIES)
