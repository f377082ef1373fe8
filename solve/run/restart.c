#include "restart.h"

#include "die.h"
#include "memory.h"

#include <stdlib.h>
#include <string.h>

static void visit_text(struct checkpoint_file *file, const char *name, char **text)
{
    int64_t length = *text ? (int64_t)strlen(*text) : 0;
    checkpoint_file_bytes(file, name, text, &length);
}

void run_texts_visit(struct run_texts *texts, struct checkpoint_file *file)
{
    visit_text(file, "program", &texts->program);
    visit_text(file, "deck", &texts->deck);
    visit_text(file, "name of the deck", &texts->deck_name);
    checkpoint_file_copy(file, "domain", texts->domain);
    visit_text(file, "names of the fields", &texts->fields);
}

void run_texts_free(struct run_texts *texts)
{
    free(texts->program);
    free(texts->deck);
    free(texts->deck_name);
    free(texts->fields);
    *texts = (struct run_texts){0};
}

/* A deck beside the checkpoint may only be the same one. */
static void check_deck(const struct arguments *arguments, const struct run_texts *texts)
{
    enum { LARGEST = 1 << 20 };
    long length;
    if (!arguments->deck) return;
    char *text = spool_text(arguments->deck, LARGEST, &length);
    if (strcmp(text, texts->deck) != 0)
        die_user("%s is of another deck than %s: leave out -d, a checkpoint has its deck inside",
                 arguments->restart, arguments->deck);
    free(text);
}

void restart_unpack(struct arguments *arguments, struct spool inputs[2])
{
    inputs[0] = spool_bytes("", 0);
    struct run_texts texts = {.domain = inputs[0].descriptor};
    if (arguments->input)
        die_user("--restart with -i %s: a checkpoint has its domain inside", arguments->input);
    struct checkpoint_file *file = checkpoint_file_open(arguments->restart);
    run_texts_visit(&texts, file);
    checkpoint_file_close(file);
    check_deck(arguments, &texts);
    arguments->input = inputs[0].path;
    arguments->deck = NULL;
    if (*texts.deck_name) {
        inputs[1] = spool_bytes(texts.deck, strlen(texts.deck));
        arguments->deck = inputs[1].path;
        setenv("HSSOLVE_DECK_NAME", texts.deck_name, 1);
    }
    run_texts_free(&texts);
}
