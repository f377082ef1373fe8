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
#   make ni-cell               a periodic cell of harmonic nickel, yields by Hall and Petch
#   make flagship              pipelines/ni-hs40
#   make flagship-horizons     the same at horizons 1, 2 and 3 spacings
#   make flagship-rate         the same at half the speed
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
# FORMULATION=corner: flagship, r40, thesis, study, fracture, loops and spacings, whose decks say correspondence with mix, in that formulation; results in
# build/results-corner.
#
# Several runs side by side are fastest on one rank each: make -j2 RANKS=1 study.
#
# SMALL=yes: the small form of a study, in build/studies: fewer runs, or shorter ones, with what then holds of its check.  Those of the
# horizons and the rate of the flagship have none: a plate of 64,000 particles is to be pulled far for them.
#
# A run is made anew when its deck is newer, not when a program is: remove its folder for that.

RESULTS := $(BUILD)/$(if $(SMALL),studies,results)$(FORMULATION:%=-%)
RANKS ?= $(shell n=$$(nproc); echo $$((n < 2 ? n : 2)))
SPACINGS ?= 25um$(if $(SMALL),, 12.5um)


STUDIES := first cells map ni-cell plate-cg errors truths flagship r40 thesis study bond-plate load-steps crack thesis-impact thesis-boundary fracture-spacing necking necking-bar taylor-bar fracture \
           solver-switch solvers rates spacings finite-elements loops thesis-calibration strip waves
.PHONY: $(STUDIES) flagship-horizons flagship-rate decks studies

# A check says how many of its assertions hold, or which does not.
must = awk -v study=$(1) $(2) -f pipelines/must.awk -f pipelines/$(1)/check.awk
curves = awk -v study=$(1) -v blank=all -v end=$(2) -f pipelines/must.awk -f pipelines/curve.awk
columns = awk -f pipelines/columns.awk

first: $(RESULTS)/first/curve.csv
	$(call curves,$@,0.04) $<
plate-cg: $(RESULTS)/plate-cg/curve.csv
	$(call must,$@,-v blank=all) $<
ni-cell: $(RESULTS)/ni-cell/curve.csv
	$(call must,$@,-v blank=all $(if $(SMALL),-v small=yes)) $<
flagship: $(RESULTS)/ni-hs40/curve.csv
	$(call curves,$@,$(if $(SMALL),0.01,0.30)) $<
r40: $(RESULTS)/ni-r40/curve.csv
	$(call curves,$@,$(if $(SMALL),0.01,0.30)) $<
thesis: $(RESULTS)/ni-hs40-thesis/curve.csv
	$(call curves,$@,$(if $(SMALL),0.01,0.25)) $<
errors: $(RESULTS)/errors/table.md $(if $(SMALL),,$(RESULTS)/errors/finite.csv)
	$(call must,$@,-v blank=all $(if $(SMALL),-v small=yes)) $(@:%=$(RESULTS)/%/elastic.csv) $(@:%=$(RESULTS)/%/plates.csv)
flagship-horizons: $(RESULTS)/ni-hs40/horizons.csv
flagship-rate: $(RESULTS)/ni-hs40/rate.csv
study: $(RESULTS)/study/figure.svg $(RESULTS)/study/table.csv

$(RESULTS)/%: SHELL := /bin/bash
$(RESULTS)/%: .SHELLFLAGS := -o pipefail -ec
$(RESULTS)/%: export PATH := $(abspath $(BUILD)/bin):$(PATH)

# A variant is a deck in which every expression finds what it replaces.
define VARY
@mkdir -p $(@D)
pipelines/vary $< $(1) > $@
endef

model_corner = -e 's/model: correspondence$$/model: corner/'
formulation_corner = $(model_corner) -e '/^  stabilisation: /d' -e '/^  horizon: 1/d'
formulation = $(formulation_$(FORMULATION))
formulation_ =

# Every run has its deck beside its results: a copy, or a variant by a rule of its own.
PLAIN := first plate-cg ni-cell ni-hs40 ni-r40 ni-hs40-thesis
small_ni-hs40 = -e 's/end_strain: 0.30/end_strain: 0.01/'
small_ni-r40 = $(small_ni-hs40)
small_ni-cell = -e 's/spacing: 2.5 um/spacing: 5 um/' -e 's/minimum_shell: 3 spacings/minimum_shell: 1 spacings/' -e 's/end_strain: 0.45/end_strain: 0.01/'
small_ni-hs40-thesis = -e 's/end_strain: 0.25/end_strain: 0.01/'
$(PLAIN:%=$(RESULTS)/%/study.yaml): $(RESULTS)/%/study.yaml: pipelines/%/study.yaml
	$(call VARY,$(if $(SMALL),$(small_$*)) $(if $(filter ni-hs% ni-r%,$*),$(formulation)))
DECKS := $(PLAIN:%=$(RESULTS)/%/study.yaml)

CELLS := bcc fcc sc direction-bcc direction-fcc direction-sc jitter random interface large contrast-bcc contrast-random contrast-large size
cells: $(RESULTS)/cells/table.csv
	$(call must,$@,-v blank=all $(if $(SMALL),-v small=yes)) $<
$(RESULTS)/cells/table.csv: $(wildcard pipelines/cells/*) pipelines/vary | all
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
$(RESULTS)/%/curve.csv: $(RESULTS)/%/study.yaml | all
	$(RUN)
$(patsubst %,$(RESULTS)/%/curve.csv,ni-hs40 ni-r40 ni-hs40-thesis): FIELDS := yes

# The README's pipe, to the letter.
$(RESULTS)/first/curve.csv: pipelines/first/study.yaml | all
	@mkdir -p $(@D)
	hsgen $< | hssolve -j $(RANKS) | hspost --plot $(@D)/curve.svg > $@

$(RESULTS)/ni-hs40-horizon-%/study.yaml: pipelines/ni-hs40/study.yaml
	$(call VARY,-e 's/^  horizon: 1 /  horizon: $* /' -e 's/^  title: HS40/&$(comma) horizon $*/')
$(RESULTS)/ni-hs40-half-speed/study.yaml: pipelines/ni-hs40/study.yaml
	$(call VARY,$(formulation) -e 's/10 m.s/5 m\/s/' -e 's/end_strain: 0.30/end_strain: 0.10/' -e 's/^  title: HS40/&$(comma) half the speed/')
DECKS += $(patsubst %,$(RESULTS)/ni-hs40-%/study.yaml,horizon-2 horizon-3 half-speed)
# Differences are those of the longer horizon against horizon 1, cost is what hssolve said at the end.
LONGER := $(foreach h,2 3,$(RESULTS)/ni-hs40-horizon-$(h)/curve.csv)
HORIZONS := $(RESULTS)/ni-hs40/curve.csv $(LONGER)
$(RESULTS)/ni-hs40/horizons.csv: $(HORIZONS) pipelines/compare.awk
	hspost -q $(HORIZONS) --plot $(@D)/horizons.svg
	for curve in $(LONGER); do hspost -q --difference $$curve $< --strain-range 0.01:0.18; done > $(@D)/horizons-difference.csv
	grep ' steps in ' $(HORIZONS:curve.csv=hssolve.log) > $(@D)/horizons-cost.txt
	awk -f pipelines/compare.awk $(HORIZONS) > $@

# The faster against the slower.
RATES := $(RESULTS)/ni-hs40/curve.csv $(RESULTS)/ni-hs40-half-speed/curve.csv
$(RESULTS)/ni-hs40/rate.csv: $(RATES)
	hspost -q $(RATES) --plot $(@D)/rate.svg
	hspost -q --difference $(RATES) --strain-range 0.01:0.1 > $@

# The study: one deck a material; spacing and seed are all that varies.  Seeds 2, 5 and 9 are those
# of the first twelve at which both phases percolate at either spacing; the cells are the same.
SEEDS := $(if $(SMALL),2,2 5 9)
STUDY := $(foreach s,$(SPACINGS),$(foreach m,cg ufg hs40 $(SEEDS:%=r40-seed%),$(RESULTS)/study/$(m)-$(s)/curve.csv))
DECKS += $(STUDY:curve.csv=study.yaml)
BOUNDS = $(foreach s,$(SPACINGS),$(RESULTS)/study/voigt-$(s).csv $(RESULTS)/study/reuss-$(s).csv)

study_spacing = -e 's/^  spacing: 25 um/  spacing: $(1:um= um)/' -e 's/^  title: .*/&$(comma) $(1:um= um)/'
define STUDY_DECKS
$(RESULTS)/study/%-$(1)/study.yaml: pipelines/study/%.yaml
	$$(call VARY,$$(call study_spacing,$(1)) $$(formulation))
$(RESULTS)/study/r40-seed%-$(1)/study.yaml: pipelines/study/r40.yaml
	$$(call VARY,-e 's/^  seed: 2 /  seed: $$* /' -e 's/^  title: R40/& seed $$*/' $$(call study_spacing,$(1)) $$(formulation))
$(RESULTS)/study/voigt-$(1).csv $(RESULTS)/study/reuss-$(1).csv &: $(RESULTS)/study/cg-$(1)/curve.csv $(RESULTS)/study/ufg-$(1)/curve.csv
	hspost -q $$^ --fraction 0.4 --strain-range 0:0.1 --voigt $$(RESULTS)/study/voigt-$(1).csv --reuss $$(RESULTS)/study/reuss-$(1).csv
endef
$(foreach s,$(SPACINGS),$(eval $(call STUDY_DECKS,$(s))))

$(RESULTS)/study/figure.svg: $(STUDY) $(BOUNDS) pipelines/study/figure.gp
	gnuplot -c pipelines/study/figure.gp $(@D) $@ $(SPACINGS)
$(RESULTS)/study/table.csv: $(STUDY) $(BOUNDS) pipelines/compare.awk
	awk -f pipelines/compare.awk $(STUDY) $(BOUNDS) > $@
	$(call curves,study,0.10) $(STUDY)

# Errors of the materials: elastic ones by a program of its own, yield and hardening by plates.
$(RESULTS)/errors/elastic.csv: $(BUILD)/tests/physics/errors
	@mkdir -p $(@D)
	$< > $@
$(RESULTS)/errors/plates.csv: pipelines/errors/plate.yaml pipelines/errors/plates | all
	pipelines/errors/plates $< $(@D)/plates $(if $(SMALL),small) > $@
$(RESULTS)/errors/table.md: pipelines/errors/table.awk $(RESULTS)/errors/elastic.csv $(RESULTS)/errors/plates.csv
	awk -F, -f $^ > $@
$(RESULTS)/errors-finite/study.yaml: pipelines/errors/plate.yaml
	$(call VARY,-e 's/end_strain: .*/end_strain: 0.16/' -e 's/1 m.s/4 m\/s/g')
$(RESULTS)/errors/finite.csv: $(RESULTS)/errors-finite/curve.csv pipelines/errors/finite.awk
	$(columns) -F, -f pipelines/errors/finite.awk $< > $@
DECKS += $(RESULTS)/errors-finite/study.yaml $(RESULTS)/errors/plates
.PHONY: $(RESULTS)/errors/plates
$(RESULTS)/errors/plates:
	pipelines/errors/plates pipelines/errors/plate.yaml $@ decks

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

bond_vary = -e 's/^title: .*/title: $*/' -e 's/^  plane: .*/  plane: $(word 1,$(1))/' -e 's/^  horizon: .*/  horizon: $(word 2,$(1))/' \
	-e 's/^  spacing: .*/  spacing: $(patsubst %mm,% mm,$(word 3,$(1)))/' -e 's/^  volumes: .*/  volumes: $(word 4,$(1))/' \
	-e 's/^  surface_correction: .*/  surface_correction: $(word 5,$(1))/' \
	$(if $(filter 4.015 5.015,$(word 2,$(1))),-e 's/length: 3 spacings/length: 5 spacings/')
$(BOND_PLATES:%=%/study.yaml): $(RESULTS)/bond-plate/%/study.yaml: pipelines/bond-plate/study.yaml
	$(call VARY,$(call bond_vary,$(subst -, ,$*)))
DECKS += $(BOND_PLATES:%=%/study.yaml)
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

DECKS += $(LOADS:%=$(RESULTS)/load-steps/%/study.yaml) $(HELD:%=$(RESULTS)/load-steps/%/study.yaml)
$(RESULTS)/load-steps/study/study.yaml: pipelines/load-steps/study.yaml
	$(call VARY)
$(RESULTS)/load-steps/strong/study.yaml: pipelines/load-steps/study.yaml
	$(call VARY,-e 's/-150 N/-4500 N/g' -e 's/ 150 N/ 4500 N/g')
# 12 times the load, time steps shorter by sqrt(1000) than the report's 0.4 us.
$(RESULTS)/load-steps/report/study.yaml: pipelines/load-steps/study.yaml
	$(call VARY,-e 's/-150 N/-1800 N/g' -e 's/ 150 N/ 1800 N/g' -e 's/safety: 0.7/safety: 0.0166/')
$(HELD:%=$(RESULTS)/load-steps/%/study.yaml): $(RESULTS)/load-steps/%/study.yaml: pipelines/load-steps/held.yaml
	$(call VARY,-e 's/^title: .*/title: $*/' -e 's/model: .*/model: $(word 1,$(subst -, ,$*))/' -e 's/spacing: 2 mm/spacing: $(patsubst %mm,% mm,$(word 2,$(subst -, ,$*)))/')
$(RESULTS)/load-steps/%/fields.e: $(RESULTS)/load-steps/%/study.yaml | all
	$(FRAMES)
$(RESULTS)/load-steps/%/frames.png: $(RESULTS)/load-steps/%/fields.e
	for frame in 2 3 4 5 6 7; do hspost --frames $< --frame $$frame --picture $(@D)/step-$$(((frame - 1) * 250)).png \
	--variables Displacement,ExternalForceX,ForceX,Damage; done
	touch $@
$(RESULTS)/load-steps/%/displacement.csv: $(RESULTS)/load-steps/%/fields.e
	hspost --frames $< --csv --variables DisplacementX,DisplacementY > $@
$(RESULTS)/load-steps/table.csv: $(HELD:%=$(RESULTS)/load-steps/%/displacement.csv) $(LOADS:%=$(RESULTS)/load-steps/%/fields.e) $(wildcard pipelines/load-steps/*.awk)
	{ echo model,spacing,strain,poissons_ratio,end_displacement_mm,strain_error_percent,poissons_ratio_error_percent,end_displacement_error_percent; \
	for name in $(HELD); do $(columns) -v name=$$name -f pipelines/load-steps/measure.awk $(@D)/$$name/displacement.csv; done; } > $@
	{ echo deck,frame,load_N,most_damage,damage_left,damage_right; for name in $(LOADS); do for frame in 2 3 4 5 6 7; do \
	hspost --frames $(@D)/$$name/fields.e --frame $$frame --csv --variables ExternalForceX,Damage \
	| awk -F, -v name=$$name,$$frame '/^[#x]/ {next} $$5 > most {most = $$5} $$1 > 0 {load += $$4*12e-9; right += $$5} $$1 < 0 {left += $$5} \
	END {printf "%s,%.9g,%.4f,%.12g,%.12g\n", name, load, most, left, right}'; done; done; } > $(@D)/loads.csv
	$(call must,load-steps,-v rows=$(words $(HELD) $(foreach l,$(LOADS),2 3 4 5 6 7))) $@ $(@D)/loads.csv

# The crack in a glass plate at two spacings: its tip through the frames, pictures.
CRACKS := 1mm$(if $(SMALL),, 0.5mm)
DECKS += $(CRACKS:%=$(RESULTS)/crack/%/study.yaml)
crack: $(RESULTS)/crack/figure.svg $(RESULTS)/crack/table.csv $(CRACKS:%=$(RESULTS)/crack/%/pictures)
$(RESULTS)/crack/0.5mm/study.yaml: pipelines/crack/study.yaml
	$(call VARY)
$(RESULTS)/crack/1mm/study.yaml: pipelines/crack/study.yaml
	$(call VARY,-e 's/spacing: 0.5 mm/spacing: 1 mm/')
$(CRACKS:%=$(RESULTS)/crack/%/fields.e): %/fields.e: %/study.yaml | all
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
DECKS += $(IMPACTS:%=$(RESULTS)/thesis-impact/%/study.yaml)
thesis-impact: $(RESULTS)/thesis-impact/table.csv $(IMPACTS:%=$(RESULTS)/thesis-impact/%/pictures)
impact_elastic = $(if $(filter elastic,$(1)),-e 's/ordinary_plastic/ordinary/' -e '/hardening:/d' -e 's/end_time: .*/end_time: 1.2 us/')
impact_slow = $(if $(filter 45,$(1)),-e 's/450 m.s/45 m\/s/' -e 's/end_time: 2.277/end_time: 2.776/')
$(IMPACTS:%=$(RESULTS)/thesis-impact/%/study.yaml): $(RESULTS)/thesis-impact/%/study.yaml: pipelines/thesis-impact/study.yaml
	$(call VARY,-e 's/^title: .*/title: $*/' $(call impact_slow,$(subst -, ,$*)) $(call impact_elastic,$(subst -, ,$*)))
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
DECKS += $(HOLDS:%=$(RESULTS)/thesis-boundary/%/study.yaml)
thesis-boundary: $(RESULTS)/thesis-boundary/table.csv $(HOLDS:%=$(RESULTS)/thesis-boundary/%/strain.png)
$(HOLDS:%=$(RESULTS)/thesis-boundary/%/study.yaml): $(RESULTS)/thesis-boundary/%/study.yaml: pipelines/thesis-boundary/plate.yaml pipelines/thesis-boundary/boundary-%.part
	@mkdir -p $(@D)
	cat $^ > $@
$(HOLDS:%=$(RESULTS)/thesis-boundary/%/fields.e): %/fields.e: %/study.yaml | all
	$(FRAMES)
$(HOLDS:%=$(RESULTS)/thesis-boundary/%/nodes.csv): %/nodes.csv: %/fields.e
	hspost --frames $< --csv --variables EquivalentPlasticStrain,VonMises > $@
$(HOLDS:%=$(RESULTS)/thesis-boundary/%/strain.png): %/strain.png: %/fields.e
	hspost --frames $< --picture $@ --variables EquivalentPlasticStrain --deformed 3 --range 0:0.08
$(RESULTS)/thesis-boundary/table.csv: $(HOLDS:%=$(RESULTS)/thesis-boundary/%/nodes.csv) $(wildcard pipelines/thesis-boundary/*.awk)
	{ echo variant,mean_percent,most_percent,mean_von_mises_MPa,asymmetry_x_percent,asymmetry_y_percent,asymmetry_turned_percent; \
	for name in $(HOLDS); do $(columns) -v name=$$name -f pipelines/thesis-boundary/measure.awk $(@D)/$$name/nodes.csv; done; } > $@
	$(call must,thesis-boundary,-v rows=$(words $(HOLDS))) $@

# Bars that part: phase, m/s of a grip, spacing in um, and whether the interval of damage is scaled by a length.
PARTING := $(foreach m,cg$(if $(SMALL),, ufg),$(foreach v,25$(if $(SMALL),, 5),$(foreach s,25 16.7 12.5,$(foreach k,local length,$(m)-$(v)-$(s)-$(k)))))
DECKS += $(PARTING:%=$(RESULTS)/fracture-spacing/%/study.yaml)
fracture-spacing: $(RESULTS)/fracture-spacing/table.csv $(if $(SMALL),,$(RESULTS)/fracture-spacing/figure.svg)
parting_ufg = $(if $(filter ufg,$(1)),-e 's/phase: CG/phase: UFG/' -e 's/onset: 0.4$(comma) full: 0.6/onset: 0.15$(comma) full: 0.3/' -e 's/end_strain: 0.55/end_strain: 0.14/')
parting_vary = -e 's/^title: .*/title: $*/' $(call parting_ufg,$(1)) -e 's/25 m.s/$(word 2,$(1)) m\/s/' \
	-e 's/spacing: 25 um/spacing: $(subst 16.7,16.6666666667,$(word 3,$(1))) um/' $(if $(filter local,$(1)),-e 's/$(comma) length: 25 um//')
$(PARTING:%=$(RESULTS)/fracture-spacing/%/study.yaml): $(RESULTS)/fracture-spacing/%/study.yaml: pipelines/fracture-spacing/study.yaml
	$(call VARY,$(call parting_vary,$(subst -, ,$*)))
$(RESULTS)/fracture-spacing/%/columns.csv: $(RESULTS)/fracture-spacing/%/study.yaml | all
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
DECKS += $(NECKS:%=$(RESULTS)/necking/%/study.yaml)
necking: $(RESULTS)/necking/table.csv
neck_fine = -e 's/spacing: .*/spacing: $(1)/'
neck_law = -e 's/hardening: .*/hardening: {law: $(1)}/' -e 's/ step: .*/ step: $(2)/' -e 's/end_strain: .*/end_strain: $(3)/'
neck_cg :=
neck_cg-16um = $(call neck_fine,16.6666666666666667 um)
neck_cg-12um = $(call neck_fine,12.5 um)
neck_cg-horizon2 = -e 's/horizon: 1/horizon: 2/' -e 's/share: 0.1/share: 0.2/'
neck_cg-horizon3 = -e 's/horizon: 1/horizon: 3/' -e 's/share: 0.1/share: 0.2/'
neck_cg-capped = -e 's/law: mix, share: 0.1/law: capped/'
neck_ufg = $(call neck_law,voce$(comma) yield: 1259.8 MPa$(comma) saturation: 564.5 MPa$(comma) rate: 238.5,0.001,0.05) -e 's/reduction: 0.001/reduction: 0.0001/'
neck_linear = $(call neck_law,linear$(comma) yield: 185 MPa$(comma) modulus: 898 MPa,0.02,1.4)
neck_power = $(call neck_law,swift$(comma) yield: 300 MPa$(comma) strength: 4356 MPa$(comma) exponent: 0.302,0.01,0.5) -e 's/reduction: 0.001/reduction: 0.0001/'
exact_cg := -v law=voce -v a=182.1 -v b=513.0 -v c=5.320
exact_ufg := -v law=voce -v a=1259.8 -v b=564.5 -v c=238.5
exact_linear := -v law=linear -v a=185 -v b=898
exact_power := -v law=swift -v a=300 -v b=4356 -v c=0.302
$(NECKS:%=$(RESULTS)/necking/%/study.yaml): $(RESULTS)/necking/%/study.yaml: pipelines/necking/study.yaml
	$(call VARY,-e 's/^title: .*/title: $*/' $(neck_$*))
$(NECKS:%=$(RESULTS)/necking/%/history.e): %/history.e: %/study.yaml | all
	$(HISTORY)
$(NECKS:%=$(RESULTS)/necking/%/row.csv): $(RESULTS)/necking/%/row.csv: $(RESULTS)/necking/%/history.e pipelines/necking/measure.awk
	hspost -q --columns $< | $(columns) -v name=$* -v section=0.04 $(exact_$(firstword $(subst -, ,$*))) -f pipelines/necking/measure.awk > $@
$(RESULTS)/necking/table.csv: $(NECKS:%=$(RESULTS)/necking/%/row.csv) pipelines/necking/check.awk
	{ echo bar,largest_stress_MPa,strain_there,considere_MPa,considere_strain,stress_error_percent,strain_error_percent,end_strain,load_left,section_ratio,largest_plastic_strain,force_evaluations; \
	cat $(filter %.csv,$^); } > $@
	$(call must,necking,-v rows=$(words $(NECKS))) $@

# The necking bar of Simo and Hughes: an eighth of a round bar between its planes of symmetry.  A name says how many particles make the radius,
# how many the half length; soft: a residual that flows at a third of the usual stress.  CalculiX' half comes from the folder; CALCULIX=yes makes it anew.
BARS := 3-150 6-150 6-150-soft $(if $(SMALL),,6-25 6-50 6-150-four_points 12-150 12-150-soft 12-300 12-300-soft)
BAR_STORED := $(if $(CALCULIX),$(RESULTS),pipelines)/necking-bar/calculix.csv
DECKS += $(BARS:%=$(RESULTS)/necking-bar/%/study.yaml)
necking-bar: $(RESULTS)/necking-bar/table.csv
bar_soft = -e 's/form: flowing/&$(comma) limit: 0.01/'
bar_four_points = -e 's/form: flowing/form: four_points/'
bar_edge = $(shell awk 'BEGIN {printf "%.17g", $(1)/$(2)}')
$(BARS:%=$(RESULTS)/necking-bar/%/study.yaml): $(RESULTS)/necking-bar/%/study.yaml: pipelines/necking-bar/study.yaml
	$(call VARY,-e 's/^title: .*/title: Necking bar $*/' $(bar_$(word 3,$(subst -, ,$*))) \
	-e 's/spacing: .*/spacing: [$(call bar_edge,26.667,$(word 2,$(subst -, ,$*))) mm$(comma) $(call bar_edge,6.413,$(firstword $(subst -, ,$*))) mm$(comma) $(call bar_edge,6.413,$(firstword $(subst -, ,$*))) mm]/')
$(BARS:%=$(RESULTS)/necking-bar/%/history.e): %/history.e: %/study.yaml | all
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

# Taylor's bar: a quarter of a round bar that strikes a plane of symmetry.  A name says how many particles make the radius, how many the length.
TAYLORS := 3-30 6-60 $(if $(SMALL),,6-120 12-120)
DECKS += $(TAYLORS:%=$(RESULTS)/taylor-bar/%/study.yaml)
taylor-bar: $(RESULTS)/taylor-bar/table.csv
$(TAYLORS:%=$(RESULTS)/taylor-bar/%/study.yaml): $(RESULTS)/taylor-bar/%/study.yaml: pipelines/taylor-bar/study.yaml
	$(call VARY,-e "s/^title: .*/title: Taylor's bar $*/" \
	-e 's/spacing: .*/spacing: [$(call bar_edge,32.4,$(word 2,$(subst -, ,$*))) mm$(comma) $(call bar_edge,3.2,$(firstword $(subst -, ,$*))) mm$(comma) $(call bar_edge,3.2,$(firstword $(subst -, ,$*))) mm]/')
$(TAYLORS:%=$(RESULTS)/taylor-bar/%/history.e): %/history.e: %/study.yaml | all
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
DECKS += $(BREAKS:%=$(RESULTS)/fracture/%/study.yaml)
fracture: $(RESULTS)/fracture/table.csv $(RESULTS)/fracture/figure.svg $(BREAKS:%=$(RESULTS)/fracture/%/broken.png)
$(BREAKS:%=$(RESULTS)/fracture/%/study.yaml): $(RESULTS)/fracture/%/study.yaml: pipelines/fracture/%.yaml
	$(call VARY,$(formulation))
$(BREAKS:%=$(RESULTS)/fracture/%/fields.e): %/fields.e: %/study.yaml | all
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
DECKS += $(SWITCHES:%=$(RESULTS)/solver-switch/%/study.yaml)
solver-switch: $(RESULTS)/solver-switch/table.csv
switch_static = -e 's/ step: .*/ step: $(1)/'
switch_hybrid = -e 's/type: .*/type: hybrid\n  explicit_strain: 0.05/' -e 's/2 m.s/4 m\/s/'
switch_explicit = -e 's/type: .*/type: explicit/' -e '/ step: /d' -e 's/2 m.s/$(1) m\/s/'
$(SWITCHES:%=$(RESULTS)/solver-switch/%/study.yaml): $(RESULTS)/solver-switch/%/study.yaml: pipelines/solver-switch/study.yaml
	$(call VARY,-e 's/^title: .*/title: $*/' $(call switch_$(firstword $(subst -, ,$*)),$(word 2,$(subst -, ,$*))))
$(SWITCHES:%=$(RESULTS)/solver-switch/%/history.e): %/history.e: %/study.yaml | all
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
DECKS += $(RATES_OF:%=$(RESULTS)/rates/%/study.yaml)
rates: $(RESULTS)/rates/table.csv
rate_static = -e 's/type: .*/type: quasi_static/' -e '/start: affine/d'
rate_hybrid = -e 's/type: .*/type: hybrid\n  explicit_strain: 0.03/' -e '/start: affine/d'
rate_explicit = -e 's/10 m.s/$(1) m\/s/'
rate_ramp = -e 's/10 m.s/$(1) m\/s/' -e 's/start: affine/start: ramp\n  ramp: 5 us/'
rate_mass = -e 's/10 m.s/5 m\/s/' -e 's/start: affine/&\n  mass_scaling: $(1)/'
rate_viscous = -e 's/start: affine/&\n  damping: $(1) 1\/s/'
rate_local = -e 's/start: affine/&\n  local_damping: $(1)/'
$(RATES_OF:%=$(RESULTS)/rates/%/study.yaml): $(RESULTS)/rates/%/study.yaml: pipelines/rates/study.yaml
	$(call VARY,-e 's/^title: .*/title: $*/' $(call rate_$(firstword $(subst -, ,$*)),$(word 2,$(subst -, ,$*))))
$(RATES_OF:%=$(RESULTS)/rates/%/history.e): %/history.e: %/study.yaml | all
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
DECKS += $(FE_SPLITS:%=$(FE)/hstools-%.yaml)
FE_RUNS := C3D8-1-0.04 C3D8I-1-0.04 C3D8I-2-0.04 C3D20R-1-0.08 C3D20R-2-0.08
FE_UNIFORM := C3D8I-1-0.08 C3D20R-1-0.08
FE_STORED := $(if $(CALCULIX),$(FE),pipelines/finite-elements)
fe_um = $(word $(1),25 12.5 8.3333333333333 6.25)
finite-elements: $(FE)/table.csv
	@command -v ccx > /dev/null || echo "finite-elements: CalculiX' half is that of pipelines/finite-elements: anew it needs ccx"

$(FE)/voxels.txt: pipelines/finite-elements/study.yaml | all
	@mkdir -p $(@D)
	hsgen $< -o $(@D)/domain.g --statistics $(@D)/statistics.csv --picture $(@D)/structure.png --peridigm $(@D)/voxels
define FE_HSTOOLS
$(FE)/hstools-$(1).yaml: pipelines/finite-elements/study.yaml
	$$(call VARY,-e 's/spacing: 25 um/spacing: $(call fe_um,$(1)) um/' -e 's/25e-6/$(call fe_um,$(1))*1e-6/')
$(FE)/hstools-$(1).csv: $(FE)/hstools-$(1).yaml $(FE)/voxels.txt pipelines/finite-elements/split.awk pipelines/finite-elements/hstools.awk
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

# Unloading and reloading.  The programme is that of programme.awk: strains to which, and strains by which it is unloaded.
LOOPED := $(if $(SMALL),cg hs40,cg ufg hs40 r40-1 r40-2 r40-3)
DECKS += $(LOOPED:%=$(RESULTS)/loops/%/study.yaml)
loops: $(RESULTS)/loops/table.csv
loops_homogeneous = -e 's/^title: .*/title: $(1)/' -e 's/topology: harmonic/topology: homogeneous\n  phase: $(1)/' -e 's/phase: structure/phase: $(1)/' \
    -e '/^  phases:/d' -e '/^  lattice:/d' -e '/^  core:/d' -e '/^  core_distance:/d' -e '/^  ufg_fraction:/d' -e '/^  minimum_shell:/d' -e '/^  seed:/d'
loops_cg = $(call loops_homogeneous,CG)
loops_ufg = $(call loops_homogeneous,UFG)
loops_r40 = -e 's/^title: .*/title: R40/' -e 's/topology: harmonic/topology: random\n  override: true/' -e '/^  lattice:/d' -e '/^  minimum_shell:/d' \
    -e 's/core_distance: .*/core_distance: 0.1 mm/' -e 's/seed: 1/seed: $(1)/'
loops_to := 0.005 0.01 0.02 0.03 0.04
loops_down_cg := 0.0024 0.0028 0.0034 0.0038
loops_down_ufg := 0 0.0158 0.0197 0.0197
loops_down := 0.0017 0.0026 0.0034 0.004
$(LOOPED:%=$(RESULTS)/loops/%/study.yaml): $(RESULTS)/loops/%/study.yaml: pipelines/loops/study.yaml pipelines/loops/programme.awk
	$(call VARY,$(call loops_$(firstword $(subst -, ,$*)),$(word 2,$(subst -, ,$*))) $(model_$(FORMULATION)))
	awk -v formulation="$(FORMULATION)" -v to="$(loops_to)" -v down="$(or $(loops_down_$*),$(loops_down))" -f pipelines/loops/programme.awk >> $@
$(LOOPED:%=$(RESULTS)/loops/%/history.e): %/history.e: %/study.yaml | all
	hsgen -q $< | hssolve -q -j $(RANKS) -H $@
LOOPS_STORED := $(if $(CALCULIX),$(RESULTS),pipelines)/loops/calculix.csv
$(RESULTS)/loops/calculix.csv: $(FE)/voxels.txt $(addprefix pipelines/,loops/programme.awk loops/calculix.awk finite-elements/mesh.awk finite-elements/split.awk finite-elements/curve.awk)
	@mkdir -p $(@D)/calculix
	awk -v by=1 -v spacing=25e-6 -f pipelines/finite-elements/split.awk $< | \
	awk -v element=C3D8I -v spacing=25e-6 -v weights=$(@D)/calculix/weights.txt -f pipelines/finite-elements/mesh.awk > $(@D)/calculix/mesh.inp
	awk -v to="$(loops_to)" -v down="$(loops_down)" -v calculix=1 -f pipelines/loops/programme.awk > $(@D)/calculix/amplitude
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
DECKS += $(FINER:%=$(RESULTS)/spacings/%/study.yaml)
spacings: $(RESULTS)/spacings/table.csv
spacing_25um := -e 's/^title: HS40, spacings/& at 25 um/'
spacing_12.5um := -e 's/spacing: 25 um/spacing: 12.5 um/'
spacing_8.33um := -e 's/spacing: 25 um/spacing: 8.333333333333333 um/'
$(FINER:%=$(RESULTS)/spacings/%/study.yaml): $(RESULTS)/spacings/%/study.yaml: pipelines/spacings/study.yaml
	$(call VARY,$(spacing_$*) $(formulation))
$(RESULTS)/spacings/table.csv: $(FINER:%=$(RESULTS)/spacings/%/curve.csv) $(wildcard pipelines/spacings/*.awk)
	$(columns) -v names="$(FINER)" -f pipelines/spacings/table.awk $(filter %.csv,$^) > $@
	$(call must,spacings) $@

# The calibrations of the thesis (table 5), row by row.
ROWS := 01 02 03 04 05 06 07 08 09 10 11 12 13 14 14-whole 15 15-whole 16 17 18 19 20
DECKS += $(ROWS:%=$(RESULTS)/thesis-calibration/%/study.yaml)
thesis-calibration: $(RESULTS)/thesis-calibration/table.csv
row_stretch = -e 's/value: 0.002/value: $(1)/' -e 's/ step: 0.0005/ step: $(2)/' -e 's/first_step: 0.00002/first_step: $(3)/'
row_harder = -e 's/modulus: 898 MPa/modulus: 2100 MPa/'
row_ufg = -e 's/yield: 185 MPa/yield: 1502 MPa/'
row_whole = -e '/^damage:/,/critical_stretch/d' -e 's/ step: 0.0005/ step: 0.005/' -e 's/end_strain: 0.05/end_strain: $(1)/'
row_crack = -e 's/^boundary:/cracks:\n  - {rectangle: [[0, $(1)], [0, $(2), 0], [0, 0, $(3)]]}\n\n&/'
row_explicit = -e 's/type: quasi_static/type: explicit\n  safety: $(1)/' -e '/step:/d' -e '/break_at_once/d' -e '/end_load/d' -e 's/end_strain: .*/end_time: 200 us/' -e 's/1 mm.s/10 m\/s/'
# A harmonic plate in place of the specimen, of 25 um and of 25 mm.
row_structure = -e '/^  specimen:/,/^  grips:/d' -e 's/^domain:/&\n  specimen: plate\n  size: [1.6 $(1), 0.4 $(1), 0.2 $(1)]\n  spacing: 0.025 $(1)\n  topology: harmonic\n  phases: {cg: M, ufg: UFG}\n  lattice: fcc\n  core: cell\n  core_distance: 0.25 $(1)\n  ufg_fraction: 0.40\n  seed: 1\n  grips: {length: 2 spacings, phase: structure}\n  gauge: {length: 0.8 $(1)}/' \
	-e 's/^damage:/  UFG: {model: correspondence, density: 7850 kg\/m3, youngs_modulus: 210 GPa, poissons_ratio: 0.31, hardening: {law: linear, yield: 1502 MPa, modulus: 4356 MPa}}\n\n&/' \
	-e 's/pair: \[M, M\], law: critical_stretch, value: 0.002/pair: [M, M], law: critical_stretch, value: 0.01/' -e 's/end_strain: 0.05/end_strain: 0.004/'
row_01 := -e 's/^title: .*/title: row 1/'
row_02 := $(call row_stretch,0.0005,0.00005,0.00001)
row_03 := $(call row_stretch,0.0001,0.00001,0.000005)
row_04 := $(call row_stretch,0.0002,0.00002,0.00001)
row_05 := $(call row_stretch,0.0002,0.00001,0.000005)
row_06 := $(row_harder) $(row_04)
row_07 := $(row_harder) $(call row_stretch,0.00005,0.000005,0.000002)
row_08 := $(row_harder) $(call row_stretch,0.00005,0.0000025,0.000001)
row_flaw = $(row_harder) $(call row_stretch,0.001,0.0001,0.00001) -e 's/\(hardening: .*\)/\1\n    flaw: {centre: [0, 0, 0], radius: $(1) mm, reduction: 0.3}/'
row_09 := $(call row_flaw,0.5)
row_10 := $(call row_flaw,4)
row_cracked = $(row_harder) $(call row_stretch,0.0001,0.00001,0.000005) $(1)
row_11 := $(call row_cracked,$(call row_crack,-3 mm$(comma) -1.3 mm,1.3 mm,1.3 mm))
row_12 := $(call row_cracked,$(call row_crack,-2 mm$(comma) -0.9 mm,4 mm,1.8 mm))
row_13 := $(call row_cracked,$(call row_crack,-6 mm$(comma) -2 mm,12 mm,4 mm)) -e 's/end_strain: 0.05/end_steps: 4/' -e 's/ step: 0.00001/ step: 1 ms/' -e 's/first_step: 0.000005/first_step: 1 ms/'
row_14 := $(row_ufg) $(call row_stretch,0.00425,0.0005,0.00002)
row_14-whole := $(row_ufg) $(call row_whole,0.02) -e 's/ step: 0.005/ step: 0.0005/'
row_15 := $(row_ufg) -e 's/modulus: 898/modulus: 4356/' $(call row_stretch,0.02,0.001,0.00002)
row_15-whole := $(row_ufg) -e 's/modulus: 898/modulus: 4356/' $(call row_whole,0.10)
row_16 := $(row_harder) $(call row_structure,mm)
row_17 := $(row_harder) $(call row_structure,m)
row_18 := $(row_harder) $(call row_explicit,0.4) -e 's/value: 0.002/value: 0.01/'
row_19 := -e 's/model: .*/model: correspondence_elastic/' -e '/hardening:/d' $(call row_explicit,0.1) -e 's/value: 0.002/value: 0.02/'
row_20 := -e 's/model: .*/model: ordinary/' -e '/hardening:/d' -e '/stabilisation/d' -e 's/horizon: 1 /horizon: 3 /' $(call row_explicit,0.4) -e 's/value: 0.002/value: 0.02/'
$(ROWS:%=$(RESULTS)/thesis-calibration/%/study.yaml): $(RESULTS)/thesis-calibration/%/study.yaml: pipelines/thesis-calibration/study.yaml
	$(call VARY,-e 's/^title: .*/title: row $*/' $(row_$*))
$(ROWS:%=$(RESULTS)/thesis-calibration/%/history.e): %/history.e: %/study.yaml | all
	$(HISTORY)
$(RESULTS)/thesis-calibration/table.csv: $(ROWS:%=$(RESULTS)/thesis-calibration/%/history.e) $(wildcard pipelines/thesis-calibration/*.awk)
	{ echo row,largest_stress_MPa,strain_there,broken,strain_at_the_end,broken_bonds,energy_drift; for name in $(ROWS); do \
	hspost -q --columns $(@D)/$$name/history.e | $(columns) -v name=$$name -f pipelines/thesis-calibration/measure.awk; done; } > $@
	$(call must,thesis-calibration,-v rows=$(words $(ROWS))) $@

# The decks of all studies, and of the runs of `make bench`.
decks: $(DECKS)
	tests/bench/runs $(RESULTS)/bench/runs decks
	tests/bench/error $(RESULTS)/bench/error decks

studies: all
	pipelines/studies $(BUILD) $(RANKS) $(STUDIES)
