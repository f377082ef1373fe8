#include "page_origin.h"

#include "html.h"
#include "memory.h"
#include "varied_columns.h"
#include "version.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_OPEN = 1, MOST_VALUES = 30, MOST_RECORDS = 200 };

/* --- what varied ------------------------------------------------------------------------------ */

static const char *value_of(const struct label *label, const char *name)
{
    for (int i = 0; i < label->values.count; i++)
        if (strcmp(label->values.items[i].name, name) == 0) return label->values.items[i].value;
    return NULL;
}

static bool is_new(const struct study *study, int k, const char *name)
{
    const char *value = value_of(&study->labels[k], name);
    for (int i = 0; value && i < k; i++) {
        const char *other = value_of(&study->labels[i], name);
        if (other && strcmp(other, value) == 0) return false;
    }
    return value;
}

static void write_values(FILE *page, const struct study *study, const char *name)
{
    int count = 0;
    for (int k = 0; k < study->count; k++) {
        if (!is_new(study, k, name)) continue;
        if (++count > MOST_VALUES) continue;
        fputs(count > 1 ? ", " : "", page);
        html_text(page, value_of(&study->labels[k], name));
    }
    if (count > MOST_VALUES) fprintf(page, " and %d more", count - MOST_VALUES);
}

void page_varied(FILE *page, const struct study *study)
{
    static const char *const roles[] = {[VARIED_QUESTION] = "asked about",
                                        [VARIED_SCATTER] = "means and deviations are taken over it",
                                        [VARIED_RESOLUTION] = "values are extrapolated to 0 of it",
                                        [VARIED_SENSITIVITY] = "one changed at a time"};
    struct varied_columns columns = varied_columns_of(study->labels, study->count);
    if (columns.count > 0) {
        html_section(page, "varied", "What varied");
        fprintf(page, "<p>%d runs.</p>\n", study->count);
        html_table(page);
        fputs("<tbody>\n", page);
        for (int i = 0; i < columns.count; i++) {
            fputs("<tr><th scope=\"row\">", page);
            html_text(page, columns.items[i].name);
            fprintf(page, "<small>%s</small></th><td>", roles[columns.items[i].role]);
            write_values(page, study, columns.items[i].name);
            fputs("</td></tr>\n", page);
        }
        fputs("</tbody></table>\n", page);
        html_end(page);
    }
    varied_columns_free(&columns);
}

/* --- provenance ------------------------------------------------------------------------------- */

static void write_fact(FILE *page, const char *name, const struct attribute *fact)
{
    fputs("<dt>", page);
    html_text(page, name);
    fputs("</dt><dd>", page);
    if (fact->text)
        html_text(page, fact->text);
    else
        html_number(page, fact->number, 0);
    fputs("</dd>\n", page);
}

static void write_text(FILE *page, const char *name, const char *text)
{
    const struct attribute fact = {.text = (char *)text};
    if (text) write_fact(page, name, &fact);
}

static void write_record(FILE *page, const struct study *study, int k)
{
    const struct attributes *facts = &study->curves[k].provenance;
    fprintf(page, "<details%s><summary>", study->count <= MOST_OPEN ? " open=\"open\"" : "");
    html_text(page, study->labels[k].curve);
    fputs("</summary>\n<dl class=\"facts\">\n", page);
    write_text(page, "file", study->labels[k].file);
    write_text(page, "solver_program", study->builds[k]);
    for (int i = 0; i < facts->count; i++) write_fact(page, facts->items[i].name, &facts->items[i]);
    fputs("</dl></details>\n", page);
}

void page_provenance(FILE *page, const struct study *study)
{
    html_section(page, "provenance", "Provenance");
    fputs("<p>This page:</p>\n<pre>", page);
    html_text(page, study->maker);
    fputs("</pre>\n", page);
    for (int k = 0; k < study->count && k < MOST_RECORDS; k++) write_record(page, study, k);
    if (study->count > MOST_RECORDS)
        fprintf(page, "<p>and %d more curves</p>\n", study->count - MOST_RECORDS);
    html_end(page);
}

/* --- decks ------------------------------------------------------------------------------------ */

/* The first curve of the same deck. */
static int first_of_deck(const struct study *study, int k)
{
    int first = 0;
    while (!study->decks[first] || strcmp(study->decks[first], study->decks[k]) != 0) first++;
    return first;
}

void page_decks(FILE *page, const struct study *study)
{
    int count = 0;
    html_section(page, "deck", "Deck");
    for (int k = 0; k < study->count; k++) {
        if (!study->decks[k] || first_of_deck(study, k) != k || ++count > MOST_RECORDS) continue;
        fprintf(page, "<details%s><summary>Deck of ", count <= MOST_OPEN ? " open=\"open\"" : "");
        html_text(page, study->labels[k].curve);
        fputs("</summary>\n<pre>", page);
        html_text(page, study->decks[k]);
        fputs("</pre></details>\n", page);
    }
    if (count == 0) fputs("<p>No deck: these are measured tables.</p>\n", page);
    if (count > MOST_RECORDS) fprintf(page, "<p>and %d more decks</p>\n", count - MOST_RECORDS);
    html_end(page);
}

/* --- citation --------------------------------------------------------------------------------- */

void page_citation(FILE *page, const struct study *study)
{
    bool computed = false;
    for (int k = 0; k < study->count; k++) computed = computed || study->decks[k];
    html_section(page, "cite", "How to cite");
    fputs("<p>The hstools authors: <cite>hstools</cite>, version ", page);
    html_text(page, hs_version);
    fputs(", GPL-3.0-or-later, and the deck above.</p>\n", page);
    if (computed)
        fputs("<p>The formulation of peridynamics: S. A. Silling, M. Epton, O. Weckner, J. Xu, "
              "E. Askari, <cite>J. Elasticity</cite> 88 (2007) 151, "
              "doi:10.1007/s10659-007-9125-1.</p>\n",
              page);
    html_end(page);
}
