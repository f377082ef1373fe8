#include "crate.h"

#include "die.h"
#include "memory.h"
#include "options.h"
#include "page.h"
#include "text_output.h"
#include "tidy.h"

#include <dirent.h>
#include <errno.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

static const char own_action[] = "#hspost-run";
static const char process[] = "https://w3id.org/ro/wfrun/process/0.5";
static const char specification[] = "https://w3id.org/ro/crate/1.1";

struct crate {
    const struct request *request;
    const struct study *study;
    json_t *graph, *parts, *actions; /* of the whole; files; what was run */
    json_t *programs;                /* ids */
    char *date;
};

static bool is_empty(const char *folder)
{
    DIR *directory = opendir(folder);
    int entries = 0;
    while (directory && entries <= 2 && readdir(directory)) entries++; /* "." and ".." */
    if (directory) closedir(directory);
    return entries <= 2;
}

/* Whether the folder is a crate that hspost wrote. */
static bool is_own(const char *folder)
{
    char *path = memory_print("%s/ro-crate-metadata.json", folder);
    json_t *all = json_load_file(path, 0, NULL), *entity;
    bool own = false;
    size_t i;
    json_array_foreach(json_object_get(all, "@graph"), i, entity)
    {
        const char *id = json_string_value(json_object_get(entity, "@id"));
        own = own || (id && strcmp(id, own_action) == 0);
    }
    json_decref(all);
    free(path);
    return own;
}

void crate_check(const char *folder)
{
    struct stat found;
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        die_user("--crate %s: %s", folder, strerror(errno));
    if (stat(folder, &found) != 0 || !S_ISDIR(found.st_mode))
        die_user("--crate %s: this is no folder", folder);
    if (!is_empty(folder) && !is_own(folder))
        die_user("--crate %s: there are files in it, and it is no crate of hspost's: they would be "
                 "replaced, or taken for parts of it; give a new folder",
                 folder);
}

/* --- entities --------------------------------------------------------------------------------- */

static json_t *reference(const char *id)
{
    return json_pack("{s:s}", "@id", id);
}

static void set(json_t *entity, const char *key, const char *text)
{
    if (!text) return;
    json_t *value = json_string(text);
    if (!value) die_user("--crate: '%s' is not UTF-8, which JSON is made of", text);
    json_object_set_new(entity, key, value);
}

static bool is_there(const struct crate *crate, const char *id)
{
    for (size_t i = 0; i < json_array_size(crate->programs); i++)
        if (strcmp(json_string_value(json_array_get(crate->programs, i)), id) == 0) return true;
    return false;
}

static json_t *add(struct crate *crate, const char *id, const char *type, const char *name)
{
    json_t *entity = json_object();
    set(entity, "@id", id);
    set(entity, "@type", type);
    set(entity, "name", name);
    json_array_append_new(crate->graph, entity);
    return entity;
}

static json_t *add_file(struct crate *crate, const char *id, const char *name, const char *format)
{
    json_t *entity = add(crate, id, "File", name);
    set(entity, "encodingFormat", format);
    json_array_append_new(crate->parts, reference(id));
    return entity;
}

/* "hsgen 0.1.0+12.g8e158c7" and what follows on other lines; returns its id, which the caller
 * frees. */
static char *add_program(struct crate *crate, const char *program, const char *usual)
{
    const char *line = program ? program : usual;
    const size_t name = strcspn(line, " \n"), all = strcspn(line, "\n");
    char *label = memory_print("%.*s", (int)name, line);
    char *version = memory_print("%.*s", (int)(all > name ? all - name - 1 : 0), line + name + 1);
    char *id = memory_print("#%s-%s", label, *version ? version : "unknown");
    if (!is_there(crate, id)) {
        json_t *entity = add(crate, id, "SoftwareApplication", label);
        if (*version) set(entity, "softwareVersion", version);
        if (line[all] == '\n') set(entity, "softwareRequirements", line + all + 1);
        json_array_append_new(crate->programs, json_string(id));
    }
    free(label);
    free(version);
    return id;
}

/* A run of a program; what it took and made comes from outside. */
static json_t *add_action(struct crate *crate, const char *id, const char *program,
                          const char *command)
{
    json_t *entity = add(crate, id, "CreateAction", id + 1);
    set(entity, "description", command);
    json_object_set_new(entity, "instrument", reference(program));
    json_object_set_new(entity, "object", json_array());
    json_object_set_new(entity, "result", json_array());
    json_array_append_new(crate->actions, reference(id));
    return entity;
}

static void link_to(json_t *action, const char *key, const char *id)
{
    json_array_append_new(json_object_get(action, key), reference(id));
}

/* --- files ------------------------------------------------------------------------------------ */

static char *path_of(const struct crate *crate, const char *name)
{
    return memory_print("%s/%s", crate->request->crate, name);
}

static void write_bytes(const struct crate *crate, const char *name, const char *bytes,
                        size_t length)
{
    char *path = path_of(crate, name);
    struct text_output output = text_output_open(path);
    if (fwrite(bytes, 1, length, output.file) != length)
        die_run("cannot write %s: %s", path, strerror(errno));
    text_output_close(&output);
    free(path);
}

/* --- what was run ----------------------------------------------------------------------------- */

/* The deck, and hsgen and hssolve, by which curve k's history came of it. */
static void add_run(struct crate *crate, int k, const char *input)
{
    const struct study *study = crate->study;
    const struct attributes *facts = &study->curves[k].provenance;
    char *deck = memory_print("deck-%04d.yaml", k + 1);
    char *domain = memory_print("#domain-%04d", k + 1);
    char *gen = memory_print("#hsgen-run-%04d", k + 1);
    char *solve = memory_print("#hssolve-run-%04d", k + 1);
    char *hsgen = add_program(crate, attributes_text(facts, "generator_program"), "hsgen");
    char *hssolve = add_program(crate, study->builds[k], "hssolve");
    write_bytes(crate, deck, study->decks[k], strlen(study->decks[k]));
    json_t *file = add_file(crate, deck, "Deck", "application/yaml");
    set(file, "alternateName", attributes_text(facts, "deck_name"));
    add(crate, domain, "CreativeWork", "Particles, from one program to the next");
    json_t *action = add_action(crate, gen, hsgen, attributes_text(facts, "generator_command"));
    link_to(action, "object", deck);
    link_to(action, "result", domain);
    action = add_action(crate, solve, hssolve, attributes_text(facts, "solver_command"));
    link_to(action, "object", domain);
    link_to(action, "result", input);
    char *const texts[] = {deck, domain, gen, solve, hsgen, hssolve};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) free(texts[i]);
}

static void add_input(struct crate *crate, int k, json_t *action)
{
    const struct study *study = crate->study;
    const struct kept *kept = &study->kept[k];
    char *name = memory_print("input-%04d.%s", k + 1, kept->is_history ? "e" : "txt");
    write_bytes(crate, name, kept->bytes, (size_t)kept->length);
    json_t *file = add_file(crate, name, study->labels[k].curve,
                            kept->is_history ? "application/x-netcdf" : "text/plain");
    set(file, "alternateName", study->labels[k].file);
    link_to(action, "object", name);
    if (study->decks[k]) add_run(crate, k, name);
    free(name);
}

static void add_results(struct crate *crate, json_t *action)
{
    static const struct {
        const char *file, *name, *format;
    } results[] = {{"report.html", "Report", "application/xhtml+xml"},
                   {"curves.csv", "Curves, a row a point", "text/csv"},
                   {"properties.csv", "Properties, a row each", "text/csv"}};
    const struct study *study = crate->study;
    char *paths[3];
    for (int i = 0; i < 3; i++) {
        paths[i] = path_of(crate, results[i].file);
        add_file(crate, results[i].file, results[i].name, results[i].format);
        link_to(action, "result", results[i].file);
    }
    page_write(crate->request, study, paths[0]);
    struct text_output output = text_output_open(paths[1]);
    tidy_write(output.file, study->curves, study->labels, study->count);
    text_output_close(&output);
    output = text_output_open(paths[2]);
    properties_write_csv(output.file, study->properties, study->labels, study->count);
    text_output_close(&output);
    for (int i = 0; i < 3; i++) free(paths[i]);
}

/* --- all -------------------------------------------------------------------------------------- */

static char *date_of(void)
{
    const char *given = getenv("SOURCE_DATE_EPOCH");
    time_t now = given ? (time_t)strtoll(given, NULL, 10) : time(NULL);
    struct tm utc;
    char text[40];
    strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S+00:00", gmtime_r(&now, &utc));
    return memory_text(text);
}

static void add_root(struct crate *crate)
{
    const struct study *study = crate->study;
    json_t *descriptor = add(crate, "ro-crate-metadata.json", "CreativeWork", NULL);
    json_object_set_new(descriptor, "conformsTo", reference(specification));
    json_object_set_new(descriptor, "about", reference("./"));
    json_t *root = add(crate, "./", "Dataset", study->labels[0].title);
    set(root, "description",
        study->question ? study->question : "Tensile curves, their properties, and their origin");
    set(root, "datePublished", crate->date);
    set(root, "license", study->license ? study->license : "Not stated by who made it");
    json_object_set_new(root, "conformsTo", reference(process));
    json_object_set_new(root, "hasPart", crate->parts);
    json_object_set_new(root, "mentions", crate->actions);
    set(add(crate, process, "CreativeWork", "Process Run Crate"), "version", "0.5");
}

static void write_metadata(const struct crate *crate)
{
    json_t *all =
        json_pack("{s:[s,s],s:o}", "@context", "https://w3id.org/ro/crate/1.1/context",
                  "https://w3id.org/ro/terms/workflow-run/context", "@graph", crate->graph);
    char *text = json_dumps(all, JSON_INDENT(2));
    write_bytes(crate, "ro-crate-metadata.json", text, strlen(text));
    free(text);
    json_decref(all);
}

void crate_write(const struct request *request, const struct study *study)
{
    static const char command[] = "# command: ";
    struct crate crate = {request,      study,        json_array(), json_array(),
                          json_array(), json_array(), date_of()};
    const char *said = strstr(study->maker, command);
    char *words = said ? memory_print("%.*s", (int)strcspn(said + strlen(command), "\n"),
                                      said + strlen(command))
                       : NULL;
    add_root(&crate);
    char *hspost = add_program(&crate, options_version(), "hspost");
    json_t *action = add_action(&crate, own_action, hspost, words);
    set(action, "endTime", crate.date);
    for (int k = 0; k < study->count; k++) add_input(&crate, k, action);
    add_results(&crate, action);
    write_metadata(&crate);
    json_decref(crate.programs);
    free(hspost);
    free(words);
    free(crate.date);
}
