#lang racket/base
;; Entries of a session: a command, or forms that are complete at the end of a line.  A prompt reads
;; them from its lines, a notebook from those of a cell (notebook/cell.rkt).
;;
;; To read an entry evaluates nothing.  Its forms are asked for when the entries before it have
;; been evaluated: the meaning of a line may rest on the names that are known then.

(require (only-in racket/string string-join)
         "command.rkt" "lines.rkt" "typed-forms.rkt"
         "../../error/complain.rkt"
         (only-in "../../error/note.rkt" note)
         "../../generic/on-demand.rkt")

(require-on-demand ["../paper-notation/line-habits.rkt" meant-as-one prime-alone]
                   ["../unknown-name/known-name.rkt" known-name? function-name?]
                   ["../unknown-name/unreadable.rkt" unreadable unclosed])

(provide read-entry entry-forms)

;; text : as it was typed; read : list of syntaxes, or #f for a command; who : the reader's name
(struct entry (text read who))

(define prompt "> ")

;; A pipe needs no word that more is wanted.
(define (continuation) (if (terminal-port? (current-input-port)) "  " ""))

;; Reads lines until they are complete forms -> entry or eof.
(define (read-entry lines)
  (define number ((line-source-number lines)))
  (define first-line ((line-source-next lines) prompt))
  (cond [(eof-object? first-line) eof]
        [(command? first-line)
         ((line-source-remember lines) first-line)
         (entry first-line #f (line-source-who lines))]
        [else (read-to-end lines number (without-prompt first-line))]))

;; Carries out a command -> list of forms, or eof to end the session
(define (entry-forms e)
  (define forms (entry-read e))
  (define habit
    (and forms (one-of-several? forms) (meant-as-one forms known-name? function-name?)))
  (cond [habit (complain (entry-who e) "~a" habit)]
        [else (or forms (run-command (entry-text e)))]))

;; The line without a prompt, which comes with lines pasted from a session.
(define (without-prompt line) (regexp-replace #px"^(?:> +)+(?=\\S)" line ""))

;; number : of the first line; noted? : did a note say that the form is still open?
(define (read-to-end lines number text [noted? #f])
  (define who (line-source-who lines))
  (define forms (with-handlers ([exn:fail:read? (lambda (e) e)]) (forms-in text number)))
  (define open? (exn:fail:read:eof? forms))
  (define prime (and open? (regexp-match? #rx"'[ \t]*$" text) (prime-alone text)))
  (when prime
    ((line-source-remember lines) text)
    (complain who "~a" prime))
  (define line (and open? (next-lines lines (lines-to-close lines text forms))))
  (cond [(string? line)
         (define note? (and (not noted?) (eq? who 'prompt) (begins-anew? line)))
         (when note? (note-open text forms))
         (read-to-end lines number (string-append text "\n" line) (or noted? note?))]
        [else
         (unless (equal? forms '()) ((line-source-remember lines) text))
         (cond [open? (raise-unfinished who text)]
               [(exn? forms) (raise-unreadable who forms)]
               [else (entry text forms who)])]))

;; -> so many lines as one text, fewer where they end; eof where there is none
(define (next-lines lines count)
  (define all (for/list ([_ (in-range count)]) ((line-source-next lines) (continuation))))
  (if (eof-object? (car all)) eof (string-join (filter string? all) "\n")))

;; A text is read again when it has grown, so all lines that close its open form are taken at once,
;; where they are at hand.  Line by line where that may be a comment, which can stand between forms.
(define (lines-to-close lines text e)
  (let look ([most 64])
    (define ahead ((line-source-ahead lines) most))
    (cond [(or (null? ahead) (in-comment? text e)) 1]
          [(lines-closing text ahead)]
          [(< (length ahead) most) (length ahead)]
          [else (look (* 4 most))])))

;; e : of the reader, who says so of #|, and of #; until its form begins
(define (in-comment? text e)
  (or (regexp-match? #rx"comment" (exn-message e)) (regexp-match? #rx"#;" text)))

;; An empty line within a form, or a definition that is not indented: the form may lack its closing
;; parenthesis.
(define (begins-anew? line) (regexp-match? #px"^\\s*$|^[(](?:define|require)\\b" line))

(define (note-open text e)
  (note (format "the form that begins with  ~a  is still open: type ~a~a"
                (first-line-of text)
                (or (unclosed e) "what is missing")
                (if (terminal-port? (current-input-port)) ", or Ctrl-C to drop it" ""))))

(define (first-line-of text)
  (define line (car (regexp-match #px"^[^\n]*" text)))
  (if (> (string-length line) 40) (string-append (substring line 0 37) "...") line))

(define (raise-unreadable who e)
  (define-values (line problem) (unreadable e))
  (complain who "~a; nothing of this was evaluated" problem))

;; Is it more than one form, or a name that may hold several, as x=3?
(define (one-of-several? forms)
  (and (pair? forms)
       (or (pair? (cdr forms))
           (and (identifier? (car forms)) (not (known-name? (syntax-e (car forms))))))))

(define (raise-unfinished who text)
  (complain who "the input ends inside a form, which is left out; it begins with  ~a"
            (first-line-of text)))
