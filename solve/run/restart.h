/* restart.h - what a checkpoint says of its run, ahead of the state: the domain and the deck it was
 * given. */
#ifndef HS_RESTART_H
#define HS_RESTART_H

#include "arguments.h"
#include "checkpoint_file.h"
#include "spool.h"

/* Bytes of a file's head, the first tables of it. */
struct run_texts {
    char *program;   /* version line of who wrote it */
    char *deck;      /* text */
    char *deck_name; /* as given beside the domain; "": it lies within */
    int domain;      /* open file as it was read, or to be written; -1: none */
    char *fields;    /* names that the frames may be found under, line by line; "": none */
};

/* Writes them, on rank 0 as they are, or reads them, each rank for itself; to be freed with
 * run_texts_free. */
void run_texts_visit(struct run_texts *texts, struct checkpoint_file *file);
void run_texts_free(struct run_texts *texts);

/* The arguments get the domain and deck of the checkpoint that they name; inputs[2] are to be
 * closed at the end of the program.  Dies (exit 2) where other ones were given. */
void restart_unpack(struct arguments *arguments, struct spool inputs[2]);

#endif
