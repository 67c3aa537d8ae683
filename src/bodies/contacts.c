/* contacts.c -- what bodies do to each other. Nothing yet. */
#include "bodies/contacts.h"

const struct body_contacts *const bodies_contacts = NULL;
