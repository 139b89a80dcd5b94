#lang racket/base
;; Results at the prompt and at the top level of a `#lang mechanics` module:
;; simplified, in the book's notation, broken over lines that fit the window.
;;
;; The printer wraps the one that was current, which writes what is no part of
;; mechanics (strings, lists, pictures) as ever, and receives the text of what
;; is as a value that prints as that text; so output keeps the colour, the
;; value history and the line ends of the editor it appears in.

(require "../display/result.rkt"
         "../generic/on-demand.rkt")

(require-on-demand [racket/pretty pretty-print-columns])

(provide install-printer! print-result)

;; ---------------------------------------------------------------------------
;; The session's printer

;; A value of `current-print`; `other` is the printer it wraps.
(struct session-printer (other)
  #:property prop:procedure
  (lambda (printer x)
    ((session-printer-other printer) (simplify-interruptibly x))))

;; Make the current printer ours; again is no harm.
(define (install-printer!)
  (define printer (current-print))
  (unless (session-printer? printer)
    (current-print (session-printer printer))))

;; Print a result of a module, whatever printer is current.  A break is the
;; reader's wish to stop the program and is left to do so.
(define (print-result x)
  (define printer (current-print))
  ((if (session-printer? printer) (session-printer-other printer) printer)
   (simplify-or-say-why x)))

;; ---------------------------------------------------------------------------
;; Simplification that cannot take the prompt down

(define (simplify-interruptibly x)
  (with-handlers ([exn:break?
                   (lambda (e)
                     (note "simplification interrupted; the result as computed:")
                     (plain-result x (output-width)))])
    (simplify-or-say-why x)))

;; Whatever it is that fails, it is told, and the value is not lost.
(define (simplify-or-say-why x)
  (with-handlers ([exn:fail?
                   (lambda (e)
                     (note (format "the result could not be simplified (~a)"
                                   (exn-message e)))
                     (plain-result x (output-width)))])
    (simplified-result x (output-width))))

(define (note text)
  (define port (current-error-port))
  (write-string (string-append "; " text "\n") port)
  (flush-output port))

;; ---------------------------------------------------------------------------
;; Width

(define default-width 79)

;; Columns there are for a line on the current output: of the terminal, or of
;; the window where the port is one that shows pictures, as DrRacket's does.
(define (output-width)
  (define port (current-output-port))
  (define columns
    (cond [(port-writes-special? port)
           (pretty-print-columns)]
          [(terminal-port? port) (terminal-columns)]
          [else default-width]))
  (if (exact-positive-integer? columns) columns default-width))

;; Racket CS knows the terminal's size, if the terminal tells it, through a primitive
;; that other builds may lack.
(define (terminal-columns)
  (with-handlers ([exn:fail:contract? (lambda (e) #f)])
    (cdr ((dynamic-require ''#%terminal 'terminal-get-screen-size)))))
