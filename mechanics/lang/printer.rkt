#lang racket/base
;; Results at the prompt and at the top level of a `#lang mechanics` module:
;; simplified, in the book's notation, broken over lines that fit the window.
;;
;; The printer wraps the current one, which writes other values (strings, lists, pictures) as ever,
;; and receives the text of ours as a value that prints as that text; so output keeps the colour,
;; the value history and the line ends of the editor it appears in.
;;
;; In a terminal a long result ends after a screen.

(require (only-in racket/list split-at)
         racket/string
         "../show/display/picture-advice.rkt" "../show/display/display-style.rkt"
         "../show/display/print-shown.rkt"
         "../show/display/receiving-printer.rkt" "../show/display/result.rkt"
         (only-in "../show/interact/live-result.rkt" live?)
         "../error/message-words.rkt" "../error/note.rkt"
         (only-in "../generic/cyclic-data.rkt" cyclic?)
         (only-in "../generic/on-demand.rkt" require-on-demand)
         (only-in "../generic/up-down.rkt" tuple?)
         (only-in "../algebra/expression/expression.rkt" symbolic?)
         (only-in "../verdict/residual-remarks.rkt" remarks-on-pi))

(require-on-demand [racket/pretty pretty-print-columns]
                   ["../show/interact/interaction-show.rkt" printed-interaction])

(provide install-printer! print-result print-more print-last
         ;; for tests
         first-screen)

;; ---------------------------------------------------------------------------
;; The session's printer

;; A value of `current-print`; `other` is the printer it wraps; `how-to-go-on` says how the rest of
;; a long result is seen; `rest` is its text, or #f; `last` is the last result that was not void.
(struct session-printer (other how-to-go-on [rest #:mutable] [last #:mutable])
  #:property prop:procedure
  (lambda (printer x)
    (unless (void? x) (set-session-printer-last! printer x))
    (define other (session-printer-other printer))
    (define-values (y remark) (present x #f))
    (define shown (simplify-interruptibly y))
    (cond [(screen?)
           (print-screen printer (printed other shown))
           (print-advice y)]
          [else (print-shown shown other)])
    (print-remark remark)
    (note-more y)
    (end-result-of-notes!)))

;; Makes the current printer ours, unless it takes results as they are.  Idempotent.
(define (install-printer! [how-to-go-on "(print-expression ...) prints all of it"])
  (define printer (current-print))
  (unless (or (session-printer? printer) (result-receiver? printer))
    (current-print (session-printer printer how-to-go-on #f (void)))))

;; Prints a result of a module, whatever printer is current, unless it takes results as they are.
;; A break stops the program.
(define (print-result x)
  (define printer (current-print))
  (cond [(result-receiver? printer) (printer x)]
        [else
         (define-values (y remark) (present x #t))
         (print-shown (simplify-or-say-why y)
                      (if (session-printer? printer) (session-printer-other printer) printer))
         (when (screen?) (print-advice y))
         (print-remark remark)
         (note-more y)])
  (end-result-of-notes!))

;; An interaction opens its window, if it may; program? : then the program waits for it at its end.
;; -> the value to be printed, and a remark beneath it, or #f
(define (present x program?)
  (if (live? x)
      (printed-interaction x (or (screen?) (eq? 'snip (manner-here))) (and program? (screen?)))
      (values x #f)))

(define (print-remark text) (when text (printf "; ~a\n" text)))

;; Notes, once in a session: on a symbol in a result that may be meant for a number, and on texts
;; of several lines.
(define (note-more x)
  (cond [(or (symbolic? x) (and (tuple? x) (not (cyclic? x))))
         (for-each note-once (remarks-on-pi x))]
        [(and (string? x) (regexp-match? #rx"\n." x))
         (note-once "a text of several lines: (display ...) shows them as lines")]))

;; ---------------------------------------------------------------------------
;; Screens

;; Is the output a terminal, of text alone?
(define (screen?)
  (define port (current-output-port))
  (and (terminal-port? port) (not (port-writes-special? port))))

(define (printed print x)
  (define port (open-output-string))
  (parameterize ([current-output-port port]) (print x))
  (get-output-string port))

;; Prints as much of the text as leaves room for the note and the next prompt.
(define (print-screen printer text)
  (define size (terminal-size))
  (define-values (shown rest more)
    (first-screen text (max 5 (- (positive (car size) 24) 4)) (positive (cdr size) 80)))
  (set-session-printer-rest! printer rest)
  (write-string shown)
  (when rest
    (printf "; ~a more lines: ~a\n" more (session-printer-how-to-go-on printer))))

;; rows, columns : size of a screen
;; -> the beginning that fits, with its newline; the rest, or #f; the number of its rows
(define (first-screen text rows columns)
  (define lines (screen-rows text columns))
  (define n (length lines))
  (cond [(<= n rows) (values text #f 0)]
        [else
         (define-values (shown more) (split-at lines rows))
         (values (as-text shown) (as-text more) (- n rows))]))

;; Lines too long for the screen are cut as the terminal cuts them.
(define (screen-rows text columns)
  (for*/list ([line (in-list (string-split (string-trim text "\n" #:left? #f) "\n" #:trim? #f))]
              [start (in-range 0 (max 1 (string-length line)) columns)])
    (substring line start (min (+ start columns) (string-length line)))))

(define (as-text rows) (string-append (joined rows "\n") "\n"))

;; Prints the next screen of the last long result.
(define (print-more)
  (define printer (current-print))
  (define rest (and (session-printer? printer) (session-printer-rest printer)))
  (if rest
      (print-screen printer rest)
      (printf "nothing is left of the last result\n")))

;; Prints the last result again, in the present style.  Was there a result?
(define (print-last)
  (define printer (current-print))
  (define last (if (session-printer? printer) (session-printer-last printer) (void)))
  (printer last)
  (not (void? last)))

(define (print-advice x)
  (print-remark (advice x)))

;; ---------------------------------------------------------------------------
;; Simplification that cannot take the prompt down

(define (simplify-interruptibly x)
  (with-handlers ([exn:break?
                   (lambda (e)
                     (note "interrupted; the result as computed:")
                     (plain-result x (output-width)))])
    (simplify-or-say-why x)))

;; A failure is told, and the value is not lost.
(define (simplify-or-say-why x)
  (with-handlers ([exn:fail?
                   (lambda (e)
                     (note (format "the result could not be simplified (~a)"
                                   (exn-message e)))
                     (plain-result x (output-width)))])
    (simplified-result x (output-width) (manner-here))))

;; ---------------------------------------------------------------------------
;; Width

(define default-width 79)

;; The columns of a line on the current output: of the terminal, or of the window, where the port
;; shows pictures, as DrRacket's does.
(define (output-width)
  (define port (current-output-port))
  (positive (cond [(port-writes-special? port) (pretty-print-columns)]
                  [(terminal-port? port) (cdr (terminal-size))]
                  [else #f])
            default-width))

(define (positive n default) (if (exact-positive-integer? n) n default))

;; (rows . columns), numbers or #f.  Racket CS knows the terminal's size, if the terminal
;; tells it, through a primitive that other builds may lack.
(define (terminal-size)
  (with-handlers ([exn:fail:contract? (lambda (e) '(#f . #f))])
    ((dynamic-require ''#%terminal 'terminal-get-screen-size))))
