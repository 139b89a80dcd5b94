#lang racket/base
;; A picture of a session at the prompt: racket terminal.rkt INPUT PICTURE
;;
;; The session is real: what the input holds is typed to the prompt, which through a pipe does
;; not show it; so it is put back where the prompt has asked for it.

(require compiler/find-exe
         pict
         (only-in racket/class send)
         racket/file
         racket/list
         racket/port
         racket/string)

;; Lines that begin with a space go on with the entry before them.
(define (entries lines)
  (for/fold ([entries '()] #:result (reverse (map reverse entries))) ([line (in-list lines)])
    (if (string-prefix? line " ")
        (cons (cons line (car entries)) (cdr entries))
        (cons (list line) entries))))

(define (prompt-prints lines)
  (define-values (process out in err)
    (subprocess #f #f 'stdout (find-exe) "-l" "mechanics/lang/prompt/start"))
  (write-string (string-join lines "\n" #:after-last "\n") in)
  (close-output-port in)
  (begin0 (port->string out)
          (subprocess-wait process)))

;; The lines on the screen in the end.
(define (screen lines)
  (define answers (cdr (regexp-split #rx"(?:(?m:^)|(?<=> ))> " (prompt-prints lines))))
  (append* (for/list ([entry (in-list (entries lines))] [answer (in-list answers)])
             (append (cons (string-append "> " (car entry))
                           (cdr entry))
                     (string-split answer "\n")))))

;; ---------------------------------------------------------------------------

(define paper "white smoke")
;; Dots are combined with the letters that they stand over.
(define font '(combine . ("Noto Sans Mono" . modern)))

(define (line->pict line)
  (colorize (text (if (string=? line "") " " line) font 13)
            (if (string-prefix? line "> ") "medium blue" "black")))

(define (picture lines)
  (define p (inset (apply vl-append 1 (map line->pict lines)) 14))
  (cc-superimpose (filled-rectangle (pict-width p) (pict-height p)
                                    #:color paper #:border-color "light gray")
                  p))

(module+ main
  (define-values (input file)
    (apply values (vector->list (current-command-line-arguments))))
  (void (send (pict->bitmap (picture (screen (file->lines input)))) save-file file 'png)))
